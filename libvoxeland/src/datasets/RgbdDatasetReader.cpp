// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/RgbdDatasetReader.h"

#include "OpticalPose.h"
#include "ReplicaReader.h"
#include "ScanNetSensReader.h"
#include "SceneNNReader.h"
#include "SevenScenesReader.h"
#include "TumReader.h"
#include "files/PictureDecoders.h"
#include "observations/MaskCamera.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/numbers.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <map>

namespace voxeland
{
void RgbdDatasetReader::setUp(std::vector<DatasetFrame> frames, const DatasetCameras& cameras)
{
    m_frames = std::move(frames);
    m_cameras = cameras;
    m_cameras.depthScale = m_options.depthScale.value_or(cameras.depthScale);
    if (!isDepthScale(m_cameras.depthScale))
        throw InputError("a depth scale of " + numberText(m_cameras.depthScale) +
                         " cannot be: " + DEPTH_SCALES + ": give the right one with --depth-scale");
    m_cameras.depth = m_options.camera.value_or(cameras.depth);
    if (cameras.registered) m_cameras.colour = m_cameras.depth;
    m_cameras.colour = m_options.colourCamera.value_or(m_cameras.colour);
    m_sizes = usualSizes();
    if (m_sizes) fitCameras();
}

void RgbdDatasetReader::fitCameras()
{
    const auto fitted = [&](const PinholeCamera& camera, const ImageSize& images, const char* which,
                            const char* option) {
        return fittedCamera(camera, images, m_cameras.recordedSizes, which, option, m_notes);
    };
    PinholeCamera& depth = m_cameras.depth;
    if (!m_options.camera)
        depth = fitted(depth, m_sizes->depth, "the depth images", "--intrinsics");
    if (m_options.colourCamera) return;
    PinholeCamera& colour = m_cameras.colour;
    if (m_cameras.registered) {
        colour = depth;
        colour.size = m_sizes->depth;
        if (m_sizes->colour == m_sizes->depth) return;
    }
    colour = fitted(colour, m_sizes->colour, "the colour images", "--color-intrinsics");
}

RgbdDatasetReader::FrameSizes RgbdDatasetReader::sizesOf(const RgbdRecord& record)
{
    const auto& depth = record.scan->rangeImage;
    const auto& colour = record.scan->intensityImage;
    const SilentDecoders silent;  // the size is that of the decoded file
    return {{static_cast<int>(depth.cols()), static_cast<int>(depth.rows())},
            {static_cast<int>(colour.getWidth()), static_cast<int>(colour.getHeight())}};
}

std::optional<RgbdDatasetReader::FrameSizes> RgbdDatasetReader::usualSizes() const
{
    constexpr size_t TRIED = 16, ENOUGH = 5;
    std::map<FrameSizes, size_t> votes;
    std::optional<FrameSizes> usual;
    const size_t step = std::max<size_t>(1, m_frames.size() / TRIED);
    size_t readable = 0;
    for (size_t i = 0; i < m_frames.size() && readable < ENOUGH; i += step) {
        try {
            const FrameSizes sizes = sizesOf(readLimited(i));
            ++readable;
            if (++votes[sizes] > (usual ? votes[*usual] : 0)) usual = sizes;
        } catch (const UnusableFrame&) {  // next() says so
        }
    }
    return usual;
}

void RgbdDatasetReader::select(int64_t first, int64_t last, size_t every)
{
    if (every == 0) throw ConfigurationError("'every' must be 1 or more");
    if (first > last)
        throw ConfigurationError("the first frame, " + std::to_string(first) +
                                 ", is behind the last, " + std::to_string(last));
    m_first = first;
    m_last = last;
    m_every = every;
}

bool RgbdDatasetReader::isSelected(size_t index) const
{
    const int64_t number = m_frames[index].number;
    return number >= m_first && number <= m_last &&
           static_cast<uint64_t>(number - m_first) % m_every == 0;
}

std::vector<size_t> RgbdDatasetReader::selected() const
{
    std::vector<size_t> indices;
    for (size_t i = 0; i < m_frames.size(); ++i)
        if (isSelected(i)) indices.push_back(i);
    return indices;
}

CObservationInstances::Ptr RgbdDatasetReader::annotationOf(size_t, const RgbdRecord&) const
{
    return nullptr;
}

void RgbdDatasetReader::applyPoseOptions(mrpt::math::TPose3D& pose) const
{
    mrpt::poses::CPose3D given = opticalPose(pose);
    if (m_options.invertPoses) given = -given;
    pose = (given + -poseOfAxes(m_options.poseAxes)).asTPose();
}

RgbdRecord RgbdDatasetReader::readLimited(size_t index) const
{
    constexpr uint64_t MOST_PIXELS = 1 << 25;  // as loadDepthImage() reads
    const auto pixels = [](const ImageSize& size) {
        return static_cast<uint64_t>(size.width) * static_cast<uint64_t>(size.height);
    };
    const PictureLimit limit(m_sizes ? std::max(pixels(m_sizes->depth), pixels(m_sizes->colour))
                                     : MOST_PIXELS);
    return read(index);
}

RgbdRecord RgbdDatasetReader::load(size_t index) const
{
    RgbdRecord record = readLimited(index);
    const FrameSizes sizes = sizesOf(record);
    if (m_sizes && (sizes < *m_sizes || *m_sizes < sizes))
        throw UnusableFrame("images of another size than those of other frames");
    const auto& depth = record.scan->rangeImage;
    if (std::all_of(depth.data(), depth.data() + depth.size(), [](auto d) { return d == 0; }))
        throw UnusableFrame("nothing measured in the depth image");
    calibrate(*record.scan, m_cameras);
    if (m_options.invertPoses || m_options.poseAxes != PoseAxes::optical)
        applyPoseOptions(*record.robotPose);
    if (m_options.annotation) record.instances = annotationOf(index, record);
    if (record.instances) attachToScan(*record.instances, *record.scan);
    return record;
}

bool RgbdDatasetReader::next(RgbdRecord& record)
{
    for (; m_next < m_frames.size(); ++m_next) {
        if (!isSelected(m_next)) continue;
        try {
            record = load(m_next);
            m_current = m_next++;
            return true;
        } catch (const UnusableFrame& e) {
            const DatasetFrame& unusable = m_frames[m_next];
            if (m_options.strict)
                throw InputError("the frame " + unusable.image + " cannot be used (" + e.what() +
                                 "): mend it, or leave --strict out");
            m_skipped.push_back({unusable, e.what()});
        }
    }
    return false;
}

namespace
{
struct Format
{
    std::unique_ptr<RgbdDatasetReader> (*open)(const std::string& folder, const DatasetOptions&);
    bool hasAnnotation;
};

template <typename Reader>
std::unique_ptr<RgbdDatasetReader> make(const std::string& folder, const DatasetOptions& options)
{
    return std::make_unique<Reader>(folder, options);
}

const std::map<std::string, Format> FORMATS = {{"7scenes", {make<SevenScenesReader>, false}},
                                               {"replica", {make<ReplicaReader>, false}},
                                               {"scannet", {openScanNet, true}},
                                               {"scenenn", {make<SceneNNReader>, true}},
                                               {"tum", {make<TumReader>, false}}};

std::vector<std::string> annotatedFormats()
{
    std::vector<std::string> names;
    for (const auto& [name, format] : FORMATS)
        if (format.hasAnnotation) names.push_back(name);
    return names;
}
}  // namespace

std::vector<std::string> datasetFormats()
{
    std::vector<std::string> names;
    for (const auto& [name, format] : FORMATS) names.push_back(name);
    return names;
}

std::unique_ptr<RgbdDatasetReader> openDataset(const std::string& format, const std::string& folder,
                                               const DatasetOptions& options)
{
    const auto found = FORMATS.find(format);
    if (found == FORMATS.end())
        throw ConfigurationError("format '" + format +
                                 "' is not known; there is: " + joined(datasetFormats(), ", "));
    if (options.annotation && !found->second.hasAnnotation)
        throw ConfigurationError("the format " + format +
                                 " has no annotation that could serve as predictions, only " +
                                 joined(annotatedFormats(), ", "));
    return found->second.open(folder, options);
}
}  // namespace voxeland
