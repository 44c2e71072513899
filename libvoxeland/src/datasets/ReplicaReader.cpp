// SPDX-License-Identifier: BSD-3-Clause
#include "ReplicaReader.h"

#include "DatasetFiles.h"
#include "ImageFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/InputFile.h"
#include "voxeland/files/Json.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr double EPOCH = 1546300800;  // 2019-01-01 00:00:00 UTC
constexpr double DEFAULT_DEPTH_SCALE = 6553.5;
constexpr ImageSize RECORDED = {1200, 680};
const PinholeCamera DEFAULT_CAMERA = {600, 600, 599.5, 339.5, {}, RECORDED};

std::vector<std::vector<double>> readLines(const fs::path& file)
{
    checkInputFile(file.string(), "the poses of Replica's frames,");
    std::ifstream in(file);
    std::vector<std::vector<double>> lines;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        auto& numbers = lines.emplace_back();
        for (double number = 0; readNumber(words, number);) numbers.push_back(number);
    }
    return lines;
}

DatasetCameras camerasFrom(const std::string& file)
{
    const auto json = readJson(file);
    try {
        const auto& c = json.at("camera");
        const PinholeCamera camera = {c.at("fx"), c.at("fy"), c.at("cx"),
                                      c.at("cy"), {},         {c.value("w", 0), c.value("h", 0)}};
        const double scale = c.at("scale");
        if (camera.fx > 0 && camera.fy > 0 && scale > 0)
            return registeredCameras(camera, scale, {RECORDED});
    } catch (const nlohmann::json::exception&) {
    }
    throw InputError(file + " has no 'camera' with positive numbers fx, fy, cx, cy and scale");
}
}  // namespace

ReplicaReader::ReplicaReader(const std::string& folder, const DatasetOptions& options)
    : RgbdDatasetReader(options), m_folder(folder)
{
    checkFolder(folder);
    static const std::regex COLOUR(R"(frame(\d{1,12})\.(?:jpg|png))");
    std::vector<DatasetFrame> frames;
    for (const auto& [number, file] : numberedFiles(m_folder / "results", COLOUR))
        frames.push_back({number, "results/" + file.filename().string()});
    if (frames.empty())
        throw InputError(folder +
                         " has no results/frame000000.jpg and so on, as Replica's scenes have that"
                         " NICE-SLAM provides");
    m_poses = readLines(m_folder / "traj.txt");
    setUp(std::move(frames), findCameras());
}

DatasetCameras ReplicaReader::findCameras()
{
    for (const fs::path& folder : {m_folder, fs::absolute(m_folder).lexically_normal() / ".."})
        if (const fs::path file = folder / "cam_params.json"; fs::exists(file))
            return camerasFrom(file.string());
    if (!options().camera || !options().depthScale)
        addNote("there is no cam_params.json: NICE-SLAM's camera and depth scale are assumed");
    return registeredCameras(DEFAULT_CAMERA, DEFAULT_DEPTH_SCALE);
}

RgbdRecord ReplicaReader::read(size_t index) const
{
    const DatasetFrame& frame = frames()[index];
    const fs::path colour = m_folder / frame.image;
    const std::string digits = colour.stem().string().substr(std::string("frame").size());
    RgbdRecord record = readImages(colour, m_folder / "results" / ("depth" + digits + ".png"));
    const auto line = static_cast<size_t>(frame.number);
    if (line >= m_poses.size()) throw UnusableFrame("no line in traj.txt");
    record.robotPose = poseFromNumbers(m_poses[line]);
    record.scan->timestamp = timeOfFrame(EPOCH, frame.number);
    return record;
}
}  // namespace voxeland
