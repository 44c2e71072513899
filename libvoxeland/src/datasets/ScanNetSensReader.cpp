// SPDX-License-Identifier: BSD-3-Clause
#include "ScanNetSensReader.h"

#include "DatasetFiles.h"
#include "ImageFiles.h"
#include "ScanNetAnnotation.h"
#include "ScanNetFolderReader.h"
#include "SensFile.h"
#include "voxeland/base/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
bool timesIncrease(const std::vector<SensFile::Frame>& frames)
{
    const auto notLater = [](const auto& a, const auto& b) { return a.depthTime >= b.depthTime; };
    return std::adjacent_find(frames.begin(), frames.end(), notLater) == frames.end();
}

bool isSens(const fs::path& file)
{
    return file.extension() == ".sens";
}
}  // namespace

struct ScanNetSensReader::Content
{
    explicit Content(const std::string& path) : file(path), timed(timesIncrease(file.frames())) {}

    SensFile file;
    bool timed;  //!< the timestamps can be used
};

ScanNetSensReader::ScanNetSensReader(const std::string& file, const DatasetOptions& options)
    : RgbdDatasetReader(options), m_file(file), m_content(std::make_unique<Content>(file))
{
    const size_t count = m_content->file.frames().size();
    if (count == 0) throw InputError(file + " holds no frames");
    std::vector<DatasetFrame> frames;
    for (size_t i = 0; i < count; ++i)
        frames.push_back({static_cast<int64_t>(i), "color/" + std::to_string(i) + ".jpg"});
    setUp(std::move(frames), m_content->file.cameras());
    if (!m_content->timed)
        addNote(
            "the timestamps do not increase from frame to frame: 30 frames a second are assumed");
    if (m_content->file.hasExtrinsics())
        addNote(
            "the extrinsics of the cameras are not the identity; they are not used, colour is"
            " taken to be where depth is");
    if (options.annotation)
        m_annotation = std::make_unique<ScanNetAnnotation>(fs::absolute(m_file).parent_path());
}

ScanNetSensReader::~ScanNetSensReader() = default;

RgbdRecord ScanNetSensReader::read(size_t index) const
{
    const SensFile& file = m_content->file;
    const auto& frame = file.frames()[index];
    RgbdRecord record;
    record.robotPose = poseFromNumbers(frame.cameraToWorld);
    record.scan = mrpt::obs::CObservation3DRangeScan::Create();
    setDepth(*record.scan, file.depth(index));
    setColour(*record.scan, file.colour(index));
    record.scan->timestamp =
        m_content->timed
            ? mrpt::Clock::fromDouble(SCANNET_EPOCH + 1e-6 * static_cast<double>(frame.depthTime))
            : timeOfFrame(SCANNET_EPOCH, static_cast<int64_t>(index));
    return record;
}

CObservationInstances::Ptr ScanNetSensReader::annotationOf(size_t index,
                                                           const RgbdRecord& record) const
{
    return m_annotation->instancesOf(static_cast<int64_t>(index), *record.scan);
}

std::unique_ptr<RgbdDatasetReader> openScanNet(const std::string& path,
                                               const DatasetOptions& options)
{
    if (isSens(path)) return std::make_unique<ScanNetSensReader>(path, options);
    if (fs::is_directory(path) && !fs::exists(fs::path(path) / "color"))
        for (const fs::path& file : entriesOf(path))
            if (isSens(file)) return std::make_unique<ScanNetSensReader>(file.string(), options);
    return std::make_unique<ScanNetFolderReader>(path, options);
}
}  // namespace voxeland
