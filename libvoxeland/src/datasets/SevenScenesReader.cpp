// SPDX-License-Identifier: BSD-3-Clause
#include "SevenScenesReader.h"

#include "DatasetFiles.h"
#include "ImageFiles.h"
#include "voxeland/base/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr double EPOCH = 1356998400;  // 2013-01-01 00:00:00 UTC, when the dataset appeared
constexpr double MILLIMETRES = 1000;
constexpr ImageSize RECORDED = {640, 480};
const PinholeCamera DEFAULT_CAMERA = {585, 585, 320, 240, {}, RECORDED};

/** Paths up to the frame number, by number. */
std::map<int64_t, fs::path> findFrames(const fs::path& folder)
{
    static const std::regex PATTERN(
        R"(frame-(\d{1,12})\.(?:color\.png|color\.jpg|depth\.png|pose\.txt))");
    auto frames = numberedFiles(folder, PATTERN);
    for (auto& [number, path] : frames) {
        const std::string name = path.filename().string();
        path = folder / name.substr(0, name.find('.'));
    }
    return frames;
}

std::vector<fs::path> findSequences(const fs::path& folder)
{
    std::vector<fs::path> sequences;
    for (const fs::path& entry : entriesOf(folder))
        if (fs::is_directory(entry) && entry.filename().string().rfind("seq-", 0) == 0)
            sequences.push_back(entry);
    if (sequences.empty()) sequences.push_back(folder);
    return sequences;
}

PinholeCamera cameraOf(const fs::path& sequence)
{
    for (const fs::path& folder : {sequence, fs::absolute(sequence).lexically_normal() / ".."})
        if (const fs::path file = folder / "camera-intrinsics.txt"; fs::exists(file))
            return readCameraMatrix(file);
    return DEFAULT_CAMERA;
}

fs::path colourFile(const fs::path& stem)
{
    const fs::path jpg = stem.string() + ".color.jpg";
    return fs::exists(jpg) ? jpg : fs::path(stem.string() + ".color.png");
}
}  // namespace

SevenScenesReader::SevenScenesReader(const std::string& folder, const DatasetOptions& options)
    : RgbdDatasetReader(options)
{
    checkFolder(folder);
    const auto sequences = findSequences(folder);
    std::vector<DatasetFrame> frames;
    for (const auto& sequence : sequences) {
        const int64_t offset = frames.empty() ? 0 : frames.back().number + 1;
        const fs::path inFolder = sequence == folder ? fs::path() : sequence.filename();
        for (const auto& [number, stem] : findFrames(sequence)) {
            frames.push_back({offset + number, (inFolder / colourFile(stem).filename()).string()});
            m_stems.push_back(stem);
        }
    }
    if (frames.empty())
        throw InputError(folder +
                         " holds neither frame-NNNNNN.color.png files nor seq-NN folders"
                         " with them, as 7-Scenes has");
    setUp(std::move(frames),
          registeredCameras(cameraOf(sequences.front()), MILLIMETRES, {RECORDED}));
}

RgbdRecord SevenScenesReader::read(size_t index) const
{
    const std::string stem = m_stems[index].string();
    const fs::path pose = stem + ".pose.txt";
    RgbdRecord record = readImages(colourFile(stem), stem + ".depth.png");
    if (!fs::exists(pose)) throw UnusableFrame("no pose file");
    record.robotPose = poseFromNumbers(readNumbers(pose));
    record.scan->timestamp = timeOfFrame(EPOCH, frames()[index].number);
    return record;
}
}  // namespace voxeland
