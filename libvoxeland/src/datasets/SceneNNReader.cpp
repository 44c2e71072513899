// SPDX-License-Identifier: BSD-3-Clause
#include "SceneNNReader.h"

#include "DatasetFiles.h"
#include "ImageFiles.h"
#include "SceneNNAnnotation.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/InputFile.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <fstream>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr double EPOCH = 1451606400;  // 2016-01-01 00:00:00 UTC
constexpr double MILLIMETRES = 1000;
constexpr ImageSize RECORDED = {640, 480};
const PinholeCamera DEFAULT_CAMERA = {544.47329, 544.47329, 320, 240, {}, RECORDED};

PinholeCamera cameraFrom(const fs::path& file)
{
    checkInputFile(file.string(), "the intrinsics");
    std::ifstream in(file);
    std::map<std::string, double> values;
    std::string key;
    for (double value = 0; in >> key && readNumber(in, value);) values[key] = value;
    const PinholeCamera camera = {values["fx"], values["fy"], values["cx"], values["cy"], {}};
    if (!(camera.fx > 0 && camera.fy > 0 && camera.cx > 0 && camera.cy > 0))
        throw InputError(file.string() + " has no lines 'fx NUMBER', and fy, cx, cy");
    return camera;
}

fs::path findTrajectory(const fs::path& folder)
{
    const std::string ending = "trajectory.log";
    for (const fs::path& entry : entriesOf(folder)) {
        const std::string name = entry.filename().string();
        if (name.size() >= ending.size() &&
            name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
            return entry;
    }
    throw InputError("there is no trajectory.log in " + folder.string());
}

bool isRecording(const fs::path& path)
{
    if (path.extension() == ".oni") return true;
    if (!fs::is_directory(path)) return false;
    for (const fs::path& entry : entriesOf(path))
        if (entry.extension() == ".oni") return true;
    return false;
}
}  // namespace

SceneNNReader::SceneNNReader(const std::string& folder, const DatasetOptions& options)
    : RgbdDatasetReader(options), m_folder(folder)
{
    static const std::regex COLOUR(R"(image(\d{1,12})\.png)");
    std::vector<DatasetFrame> frames;
    for (const auto& [number, file] : numberedFiles(m_folder / "image", COLOUR))
        frames.push_back({number, "image/" + file.filename().string()});
    if (frames.empty() && isRecording(folder))
        throw InputError(folder +
                         " is an OpenNI recording: extract its images first with SceneNN's"
                         " playback tool (playback NNN.oni FOLDER), then give FOLDER");
    checkFolder(folder);
    if (frames.empty())
        throw InputError(folder +
                         " has no image/image00001.png and so on, as SceneNN's playback"
                         " tool writes");
    m_firstImage = frames.front().number == 0 ? 0 : 1;
    readTrajectory();
    setUp(std::move(frames), registeredCameras(findCamera(), MILLIMETRES, {RECORDED}));
    if (options.annotation) m_annotation = std::make_unique<SceneNNAnnotation>(folder);
}

SceneNNReader::~SceneNNReader() = default;

PinholeCamera SceneNNReader::findCamera()
{
    for (const fs::path& folder : {m_folder, fs::absolute(m_folder).lexically_normal() / ".."})
        for (const fs::path& file : {folder / "asus.ini", folder / "intrinsic" / "asus.ini"})
            if (fs::exists(file)) return cameraFrom(file);
    if (!options().camera) addNote("there is no asus.ini: SceneNN's Asus camera is assumed");
    return DEFAULT_CAMERA;
}

void SceneNNReader::readTrajectory()
{
    const fs::path file = findTrajectory(m_folder);
    checkInputFile(file.string(), "the trajectory");
    std::ifstream in(file);
    bool idsCount = true;
    for (int64_t id = 0; in >> id >> std::ws;) {
        idsCount = idsCount && id - static_cast<int64_t>(m_poses.size()) <= 1 &&
                   id >= static_cast<int64_t>(m_poses.size());
        std::vector<double> block;  // two more ids, and the matrix
        for (double number = 0; block.size() < 18 && readNumber(in, number);)
            block.push_back(number);
        if (block.size() < 18)
            throw InputError(file.string() + " is cut off or damaged: block " +
                             std::to_string(m_poses.size()) + " is not 3 numbers and a 4x4 matrix");
        m_poses.emplace_back(block.begin() + 2, block.end());
    }
    if (!in.eof() || m_poses.empty())
        throw InputError(file.string() +
                         " is not a trajectory of blocks of 3 numbers and a 4x4"
                         " matrix");
    if (!idsCount)
        addNote(
            "the numbers in the trajectory do not count its blocks: they are not used, blocks"
            " belong to images in order");
}

RgbdRecord SceneNNReader::read(size_t index) const
{
    const DatasetFrame& frame = frames()[index];
    const fs::path colour = m_folder / frame.image;
    const std::string digits = colour.stem().string().substr(std::string("image").size());
    RgbdRecord record = readImages(colour, m_folder / "depth" / ("depth" + digits + ".png"));
    const auto block = static_cast<size_t>(frame.number - m_firstImage);
    if (block >= m_poses.size()) throw UnusableFrame("no block in the trajectory");
    record.robotPose = poseFromNumbers(m_poses[block]);
    record.scan->timestamp = timeOfFrame(EPOCH, frame.number);
    return record;
}

CObservationInstances::Ptr SceneNNReader::annotationOf(size_t, const RgbdRecord& record) const
{
    return m_annotation->instancesOf(record);
}
}  // namespace voxeland
