// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include "ImageFolder.h"
#include "voxeland/io/GzOutputFile.h"
#include "voxeland/rawlogs/RawlogFiles.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <optional>
#include <utility>

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
        : options(o), staged(file), rawlog(staged.part().rawlog.string())
    {
        if (!options.embedImages) images.emplace(staged.part().images);
    }

    Options options;
    StagedRawlog staged;
    GzOutputFile rawlog;
    std::optional<GzOutputFile> sidecar;
    std::optional<ImageFolder> images;
};

RgbdRawlogWriter::RgbdRawlogWriter(const std::string& file, const Options& options)
    : m(std::make_unique<Implementation>(file, options))
{
}

RgbdRawlogWriter::~RgbdRawlogWriter() = default;

void RgbdRawlogWriter::write(const RgbdRecord& record)
{
    auto& scan = *record.scan;
    if (!m->options.comment.empty()) {
        mrpt::obs::CObservationComment comment;
        comment.timestamp =
            scan.timestamp;  // MRPT's default, now, would end the rawlog's time span
        comment.sensorLabel = "comment";
        comment.text = std::exchange(m->options.comment, {});
        m->rawlog.writeObject(comment);
    }
    if (record.robotPose) {
        mrpt::obs::CObservationRobotPose pose;
        pose.timestamp = scan.timestamp;
        pose.sensorLabel = "pose";
        pose.pose.mean = mrpt::poses::CPose3D(*record.robotPose);
        pose.pose.cov.setZero();
        m->rawlog.writeObject(pose);
    }
    if (m->images) {
        m->images->moveImagesOf(scan);
        m->rawlog.writeObject(scan);
    } else {
        const JpegScope jpeg;
        // A new image of the same pixels: one that came from a file would store its name instead.
        if (scan.intensityImage.isExternallyStored())
            scan.intensityImage =
                mrpt::img::CImage(scan.intensityImage.asCvMatRef(), mrpt::img::SHALLOW_COPY);
        m->rawlog.writeObject(scan);
    }
    if (!record.instances) return;
    if (m->options.embedInstances) {
        m->rawlog.writeObject(*record.instances);
    } else {
        if (!m->sidecar) m->sidecar.emplace(m->staged.part().sidecar.string());
        m->sidecar->writeObject(*record.instances);
    }
}

void RgbdRawlogWriter::close()
{
    m->rawlog.close();
    if (m->sidecar) m->sidecar->close();
    m->staged.putInPlace();
}
}  // namespace voxeland
