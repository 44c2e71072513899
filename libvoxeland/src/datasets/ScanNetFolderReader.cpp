// SPDX-License-Identifier: BSD-3-Clause
#include "ScanNetFolderReader.h"

#include "DatasetFiles.h"
#include "ImageFiles.h"
#include "ScanNetAnnotation.h"
#include "SensFile.h"
#include "voxeland/base/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr double MILLIMETRES = 1000;
}  // namespace

ScanNetFolderReader::ScanNetFolderReader(const std::string& folder, const DatasetOptions& options)
    : RgbdDatasetReader(options), m_folder(folder)
{
    checkFolder(folder);
    static const std::regex COLOUR(R"((\d{1,12})\.(?:jpg|png))");
    std::vector<DatasetFrame> frames;
    for (const auto& [number, file] : numberedFiles(m_folder / "color", COLOUR))
        frames.push_back({number, "color/" + file.filename().string()});
    if (frames.empty())
        throw InputError(folder +
                         " holds neither a .sens file nor color/0.jpg and so on, as"
                         " ScanNet's scenes do");
    const fs::path intrinsic = m_folder / "intrinsic";
    DatasetCameras cameras;
    cameras.depth = readCameraMatrix(intrinsic / "intrinsic_depth.txt");
    cameras.colour = readCameraMatrix(intrinsic / "intrinsic_color.txt");
    cameras.registered = false;
    cameras.depthScale = MILLIMETRES;
    cameras.recordedSizes = SCANNET_SIZES;
    setUp(std::move(frames), cameras);
    if (options.annotation) m_annotation = std::make_unique<ScanNetAnnotation>(m_folder);
}

ScanNetFolderReader::~ScanNetFolderReader() = default;

RgbdRecord ScanNetFolderReader::read(size_t index) const
{
    const DatasetFrame& frame = frames()[index];
    const std::string number = fs::path(frame.image).stem().string();
    const fs::path pose = m_folder / "pose" / (number + ".txt");
    RgbdRecord record = readImages(m_folder / frame.image, m_folder / "depth" / (number + ".png"));
    if (!fs::exists(pose)) throw UnusableFrame("no pose file");
    record.robotPose = poseFromNumbers(readNumbers(pose));
    record.scan->timestamp = timeOfFrame(SCANNET_EPOCH, frame.number);
    return record;
}

CObservationInstances::Ptr ScanNetFolderReader::annotationOf(size_t index,
                                                             const RgbdRecord& record) const
{
    return m_annotation->instancesOf(frames()[index].number, *record.scan);
}
}  // namespace voxeland
