// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/SevenScenesReader.h"

#include "ImageFiles.h"
#include "voxeland/datasets/OpticalPose.h"
#include "voxeland/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr double EPOCH = 1356998400;  // 2013-01-01 00:00:00 UTC, when the dataset appeared
constexpr int64_t FRAMES_PER_SECOND = 30;
constexpr float KINECT_MAX_RANGE = 10;  // [m]
constexpr const char* INTRINSICS_FILE = "camera-intrinsics.txt";

/** All numbers of a text file; what is no number ends it. */
std::vector<double> readNumbers(const fs::path& file)
{
    std::ifstream in(file);
    std::vector<double> numbers;
    for (std::string word; in >> word;) {
        char* end = nullptr;
        numbers.push_back(std::strtod(word.c_str(), &end));  // takes "nan", unlike operator>>
        if (*end != '\0') break;
    }
    return numbers;
}

mrpt::math::TPose3D readPose(const fs::path& file)
{
    if (!fs::exists(file)) throw UnusableFrame("no pose file");
    const auto numbers = readNumbers(file);
    std::array<double, 16> matrix{};
    if (numbers.size() != matrix.size()) throw UnusableFrame("pose is not a 4x4 matrix");
    std::copy(numbers.begin(), numbers.end(), matrix.begin());
    const auto pose = poseFromOptical(matrix);
    if (!pose) throw UnusableFrame("pose is not a rigid transform");
    return *pose;
}

/** Paths up to the frame number, by number. */
std::map<int64_t, fs::path> findFrames(const fs::path& folder)
{
    static const std::regex PATTERN(
        R"(frame-(\d{1,15})\.(color\.png|color\.jpg|depth\.png|pose\.txt))");
    std::map<int64_t, fs::path> frames;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        std::smatch match;
        if (std::regex_match(name, match, PATTERN))
            frames.emplace(std::stoll(match[1]), folder / name.substr(0, name.find('.')));
    }
    return frames;
}

std::vector<fs::path> findSequences(const fs::path& folder)
{
    std::vector<fs::path> sequences;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory() && entry.path().filename().string().rfind("seq-", 0) == 0)
            sequences.push_back(entry.path());
    std::sort(sequences.begin(), sequences.end());
    if (sequences.empty()) sequences.push_back(folder);
    return sequences;
}

fs::path colourFile(const fs::path& stem)
{
    const fs::path jpg = stem.string() + ".color.jpg";
    return fs::exists(jpg) ? jpg : fs::path(stem.string() + ".color.png");
}

mrpt::Clock::time_point timeOf(int64_t frame)
{
    const auto ticks = frame * mrpt::Clock::period::den / FRAMES_PER_SECOND;
    return mrpt::Clock::fromDouble(EPOCH) + mrpt::Clock::duration(ticks);
}
}  // namespace

SevenScenesReader::SevenScenesReader(const std::string& folder)
{
    if (!fs::is_directory(folder)) throw InputError("there is no folder " + folder);
    const auto sequences = findSequences(folder);
    m_intrinsics = readIntrinsics(sequences.front());
    std::vector<DatasetFrame> frames;
    for (const auto& sequence : sequences) {
        const int64_t offset = frames.empty() ? 0 : frames.back().number + 1;
        for (const auto& [number, stem] : findFrames(sequence)) {
            frames.push_back({offset + number, fs::relative(colourFile(stem), folder).string()});
            m_stems.push_back(stem);
        }
    }
    if (frames.empty())
        throw InputError(folder +
                         " holds neither frame-NNNNNN.color.png files nor seq-NN folders"
                         " with them, as 7-Scenes has");
    setFrames(std::move(frames));
}

SevenScenesReader::Intrinsics SevenScenesReader::readIntrinsics(const fs::path& sequence)
{
    for (const fs::path& folder : {sequence, fs::absolute(sequence).lexically_normal() / ".."}) {
        const fs::path file = folder / INTRINSICS_FILE;
        if (!fs::exists(file)) continue;
        const auto k = readNumbers(file);
        const bool finite =
            std::all_of(k.begin(), k.end(), [](double v) { return std::isfinite(v); });
        if (k.size() != 9 || !finite || k[0] <= 0 || k[4] <= 0)
            throw InputError(file.string() + " is not a 3x3 matrix of camera intrinsics");
        return {k[0], k[4], k[2], k[5]};
    }
    return {};
}

RgbdRecord SevenScenesReader::read(size_t index) const
{
    const std::string stem = m_stems[index].string();
    const fs::path colour = colourFile(stem), depth = stem + ".depth.png";
    if (!fs::exists(colour)) throw UnusableFrame("no colour image");
    if (!fs::exists(depth)) throw UnusableFrame("no depth image");

    RgbdRecord record;
    record.robotPose = std::make_shared<mrpt::math::TPose3D>(readPose(stem + ".pose.txt"));
    record.scan = mrpt::obs::CObservation3DRangeScan::Create();
    auto& scan = *record.scan;
    scan.timestamp = timeOf(frames()[index].number);
    scan.sensorLabel = "RGBD";
    scan.range_is_depth = true;
    scan.rangeUnits = 0.001F;
    scan.maxRange = KINECT_MAX_RANGE;
    loadDepth(scan, depth.string());
    loadColour(scan, colour.string());
    const auto width = static_cast<size_t>(scan.rangeImage.cols());
    const auto height = static_cast<size_t>(scan.rangeImage.rows());
    if (scan.intensityImage.getWidth() != width || scan.intensityImage.getHeight() != height)
        throw InputError(colour.string() + " and " + depth.string() + " differ in size");

    scan.cameraParams.ncols = static_cast<uint32_t>(width);
    scan.cameraParams.nrows = static_cast<uint32_t>(height);
    scan.cameraParams.setIntrinsicParamsFromValues(m_intrinsics.fx, m_intrinsics.fy,
                                                   m_intrinsics.cx, m_intrinsics.cy);
    scan.cameraParamsIntensity = scan.cameraParams;
    using namespace mrpt::literals;
    scan.relativePoseIntensityWRTDepth = {0, 0, 0, -90.0_deg, 0.0_deg, -90.0_deg};
    return record;
}
}  // namespace voxeland
