// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include "ImageFolder.h"
#include "StagedRawlog.h"
#include "files/GzOutputFile.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <optional>
#include <utility>

using mrpt::obs::CObservation;
using mrpt::obs::CObservationOdometry;
using mrpt::poses::CPose2D;

namespace voxeland
{
namespace
{
/** Has MRPT store images as JPEG while it lives; MRPT's settings are of the whole process. */
class JpegScope
{
 public:
    JpegScope()
    {
        mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(false);
        mrpt::img::CImage::SERIALIZATION_JPEG_QUALITY(JPEG_QUALITY);
    }
    ~JpegScope()
    {
        mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(m_disabled);
        mrpt::img::CImage::SERIALIZATION_JPEG_QUALITY(m_quality);
    }
    JpegScope(const JpegScope&) = delete;
    JpegScope& operator=(const JpegScope&) = delete;

 private:
    bool m_disabled = mrpt::img::CImage::DISABLE_JPEG_COMPRESSION();
    int m_quality = mrpt::img::CImage::SERIALIZATION_JPEG_QUALITY();
};
}  // namespace

struct RgbdRawlogWriter::Implementation
{
    Implementation(const std::string& file, const Options& o)
        : options(o),
          staged(file),
          rawlog(staged.part().rawlog.string(), GzOutputFile::FASTEST,
                 staged.target().rawlog.string())
    {
        if (!options.embedImages)
            images.emplace(staged.part().images, staged.target().images.string());
    }

    /** What is known of a frame and belongs in the rawlog, in order. */
    [[nodiscard]] std::vector<CObservation::Ptr> observationsOf(const RgbdRecord& record) const;
    void writeAsEntries(const RgbdRecord& record);
    void writeAsSensoryFrame(const RgbdRecord& record);

    Options options;
    StagedRawlog staged;
    GzOutputFile rawlog;
    std::optional<GzOutputFile> sidecar;
    std::optional<ImageFolder> images;
    std::optional<CPose2D> odometry;  //!< of the last frame
};

std::vector<CObservation::Ptr> RgbdRawlogWriter::Implementation::observationsOf(
    const RgbdRecord& record) const
{
    std::vector<CObservation::Ptr> result = record.others;
    if (record.robotPose) {
        const auto pose = mrpt::obs::CObservationRobotPose::Create();
        pose->timestamp = record.scan->timestamp;
        pose->sensorLabel = "pose";
        pose->pose.mean = mrpt::poses::CPose3D(*record.robotPose);
        pose->pose.cov.setZero();
        if (record.poseCovariance) pose->pose.cov = *record.poseCovariance;
        result.push_back(pose);
    }
    result.push_back(record.scan);
    if (record.instances && options.embedInstances) result.push_back(record.instances);
    return result;
}

void RgbdRawlogWriter::Implementation::writeAsEntries(const RgbdRecord& record)
{
    if (!options.comment.empty()) {
        mrpt::obs::CObservationComment comment;
        // MRPT's default, now, would end the rawlog's time span.
        comment.timestamp = record.scan->timestamp;
        comment.sensorLabel = "comment";
        comment.text = std::exchange(options.comment, {});
        rawlog.writeObject(comment);
    }
    const JpegScope jpeg;
    for (const auto& observation : observationsOf(record)) rawlog.writeObject(*observation);
}

void RgbdRawlogWriter::Implementation::writeAsSensoryFrame(const RgbdRecord& record)
{
    mrpt::obs::CSensoryFrame frame;
    mrpt::obs::CActionCollection actions;
    for (const auto& observation : observationsOf(record)) {
        const auto now = std::dynamic_pointer_cast<CObservationOdometry>(observation);
        if (!now) {
            frame.insert(observation);
            continue;
        }
        mrpt::obs::CActionRobotMovement2D movement;
        movement.timestamp = now->timestamp;
        movement.computeFromOdometry(now->odometry - odometry.value_or(now->odometry), {});
        odometry = now->odometry;
        actions.insert(movement);
    }
    rawlog.writeObject(actions);
    const JpegScope jpeg;
    rawlog.writeObject(frame);
}

RgbdRawlogWriter::RgbdRawlogWriter(const std::string& file, const Options& options)
    : m(std::make_unique<Implementation>(file, options))
{
}

RgbdRawlogWriter::~RgbdRawlogWriter() = default;

void RgbdRawlogWriter::write(const RgbdRecord& record)
{
    auto& scan = *record.scan;
    if (m->images)
        m->images->moveImagesOf(scan);
    else if (scan.intensityImage.isExternallyStored())
        // A new image of the same pixels: one that came from a file would store its name instead.
        scan.intensityImage =
            mrpt::img::CImage(scan.intensityImage.asCvMatRef(), mrpt::img::SHALLOW_COPY);

    if (m->options.sensoryFrames)
        m->writeAsSensoryFrame(record);
    else
        m->writeAsEntries(record);
    if (!record.instances || m->options.embedInstances) return;
    if (!m->sidecar)
        m->sidecar.emplace(m->staged.part().sidecar.string(), GzOutputFile::FASTEST,
                           m->staged.target().sidecar.string());
    m->sidecar->writeObject(*record.instances);
}

void RgbdRawlogWriter::close()
{
    m->rawlog.close();
    if (m->sidecar) m->sidecar->close();
    m->staged.putInPlace();
}
}  // namespace voxeland
