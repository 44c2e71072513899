// SPDX-License-Identifier: BSD-3-Clause
#include "TumReader.h"

#include "DatasetFiles.h"
#include "ImageFiles.h"
#include "OpticalPose.h"
#include "TimeAssociation.h"
#include "files/NamedFile.h"
#include "observations/TimedLines.h"
#include "observations/Trajectory.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr double DEPTH_SCALE = 5000;
constexpr double MAX_TIME_APART = 0.02;  // [s]
constexpr double MAX_POSE_GAP = 0.1;     // [s]

/** The dataset's own calibrations; freiburg3's images are undistorted. */
const std::array<PinholeCamera, 3> CAMERAS = {
    {{517.306408,
      516.469215,
      318.643040,
      255.313989,
      {0.262383, -0.953104, -0.005358, 0.002628, 1.163314}},
     {520.908620,
      521.007327,
      325.141442,
      249.701764,
      {0.231222, -0.784899, -0.003257, -0.000105, 0.917205}},
     {535.4, 539.2, 320.1, 247.6, {}}}};

/** Number of the camera, from 1, that a folder's name tells; 0 if none. */
size_t cameraNumber(const fs::path& folder)
{
    static const std::regex PATTERN(R"((?:freiburg|fr)([123])(?![0-9]))");
    fs::path path = fs::absolute(folder).lexically_normal();
    if (path.filename().empty()) path = path.parent_path();
    const std::string name = path.filename().string();
    std::smatch match;
    return std::regex_search(name, match, PATTERN) ? std::stoul(match[1]) : 0;
}

/** A file's name as a list gives it, or with slashes where it was written on Windows. */
std::string existingName(const fs::path& folder, const std::string& listed)
{
    std::string name = listed;
    std::error_code error;
    if (!fs::exists(folder / name, error)) std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}
}  // namespace

TumReader::TumReader(const std::string& folder, const DatasetOptions& options)
    : RgbdDatasetReader(options), m_folder(folder), m_poses(MAX_POSE_GAP)
{
    checkFolder(folder);
    m_colour = readList("rgb.txt");
    m_depth = readList("depth.txt");
    m_depthOfColour = associateTimes(listed(m_colour), listed(m_depth), MAX_TIME_APART);
    auto trajectory = Trajectory::fromTumFile((m_folder / "groundtruth.txt").string(), MAX_POSE_GAP,
                                              options.strict);
    m_poses = std::move(trajectory.poses);
    for (const std::string& note : trajectory.notes) addNote(note);
    checkTimes("rgb.txt", timesOf(m_colour), timesOf(m_depth));
    checkTimes("groundtruth.txt", m_poses.times(), timesOf(m_depth));

    const size_t camera = cameraNumber(folder);
    if (camera == 0 && !options.camera)
        throw ConfigurationError("the name of the folder " + folder +
                                 " does not tell the camera (freiburg1, freiburg2 or freiburg3):"
                                 " give it with --intrinsics, such as 525,525,319.5,239.5");
    if (!options.camera)
        addNote("the camera is that of freiburg" + std::to_string(camera) +
                ", as the folder's name says");
    std::vector<DatasetFrame> frames;
    for (const auto& image : m_colour)
        frames.push_back({static_cast<int64_t>(frames.size()), image.file});
    setUp(std::move(frames),
          registeredCameras(camera == 0 ? PinholeCamera() : CAMERAS[camera - 1], DEPTH_SCALE));
}

std::vector<TumReader::TimedFile> TumReader::readList(const std::string& name)
{
    const fs::path file = m_folder / name;
    const auto text =
        TimedLines::fromFile(file.string(), file.string(), "timestamp file", options().strict);
    if (text.lines.empty()) throw InputError(file.string() + " names no image");
    for (const std::string& note : text.notes) addNote(note);
    if (text.leftOut.count() > 0)
        addNote(text.leftOut.told("line of " + file.string(), "lines of " + file.string()));
    std::vector<TimedFile> list;
    for (const TimedLine& line : text.lines) {
        list.push_back({line.time, existingName(m_folder, line.rest)});
        static_cast<void>(namedFile(m_folder, list.back().file, file.string(), Links::followed,
                                    options().trustPaths));
    }
    return list;
}

std::vector<double> TumReader::listed(const std::vector<TimedFile>& list)
{
    std::vector<double> times;
    for (const TimedFile& image : list) times.push_back(image.time);
    return times;
}

TimeRange TumReader::timesOf(const std::vector<TimedFile>& list)
{
    TimeRange times;
    for (const TimedFile& image : list) times.include(image.time);
    return times;
}

void TumReader::checkTimes(const std::string& name, const TimeRange& times,
                           const TimeRange& depthTimes) const
{
    if (times.overlaps(depthTimes)) return;
    throw NothingToMapError("no time of " + name + " (" + times.text() +
                            ") is within those of depth.txt (" + depthTimes.text() + ") of " +
                            m_folder.string() + ": give all times in seconds from the same zero");
}

RgbdRecord TumReader::read(size_t index) const
{
    if (m_depthOfColour[index] < 0)
        throw UnusableFrame("no depth image within 20 ms that is not another frame's");
    const TimedFile& depth = m_depth[static_cast<size_t>(m_depthOfColour[index])];
    const auto time = mrpt::Clock::fromDouble(depth.time);
    const auto pose = m_poses.at(time);
    if (!pose) throw UnusableFrame("no poses within 0.1 s to interpolate between");
    RgbdRecord record = readImages(m_folder / m_colour[index].file, m_folder / depth.file);
    record.robotPose =
        std::make_shared<mrpt::math::TPose3D>(poseFromOptical(mrpt::poses::CPose3D(*pose)));
    record.scan->timestamp = time;
    return record;
}
}  // namespace voxeland
