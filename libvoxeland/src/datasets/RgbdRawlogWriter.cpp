// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/RgbdRawlogWriter.h"

#include "ImageFolder.h"
#include "voxeland/errors.h"
#include "voxeland/io/GzOutputFile.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <filesystem>
#include <optional>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr auto EXTENSION = ".rawlog";

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

/** A file or folder being written beside the one it will replace. */
struct Staged
{
    fs::path target;
    fs::path part = target.string() + ".part";

    void discard() const
    {
        std::error_code ignored;
        fs::remove_all(part, ignored);
    }
    void putInPlace() const { fs::rename(part, target); }
};

/** The file's name without its extension. */
std::string stemOf(const std::string& file)
{
    const fs::path path(file);
    if (path.extension() != EXTENSION || path.stem().empty())
        throw ConfigurationError("the name of the rawlog " + file + " must end in " + EXTENSION);
    return (path.parent_path() / path.stem()).string();
}
}  // namespace

struct RgbdRawlogWriter::Implementation
{
    Implementation(const std::string& file, const Options& o)
        : options(o),
          rawlog{file},
          sidecar{stemOf(file) + ".instances" + EXTENSION},
          images{stemOf(file) + "_Images"}
    {
        if (!fs::exists(rawlog.target) && fs::exists(images.target))
            throw OutputError("the folder " + images.target.string() +
                              " is in the way of the images of " + file +
                              ": remove it or choose another name");
        discard();  // leftovers of a run that died
    }

    void discard() const
    {
        for (const auto* s : {&rawlog, &sidecar, &images}) s->discard();
    }

    Options options;
    Staged rawlog, sidecar, images;
    std::optional<GzOutputFile> rawlogFile, sidecarFile;
    std::optional<ImageFolder> imageFolder;
    bool closed = false;
};

RgbdRawlogWriter::RgbdRawlogWriter(const std::string& file, const Options& options)
    : m(std::make_unique<Implementation>(file, options))
{
    m->rawlogFile.emplace(m->rawlog.part.string());
    if (!options.embedImages) m->imageFolder.emplace(m->images.part);
    if (options.comment.empty()) return;
    mrpt::obs::CObservationComment comment;
    comment.text = options.comment;
    m->rawlogFile->writeObject(comment);
}

RgbdRawlogWriter::~RgbdRawlogWriter()
{
    if (!m->closed) m->discard();
}

void RgbdRawlogWriter::write(const RgbdRecord& record)
{
    auto& scan = *record.scan;
    if (record.robotPose) {
        mrpt::obs::CObservationRobotPose pose;
        pose.timestamp = scan.timestamp;
        pose.sensorLabel = "pose";
        pose.pose.mean = mrpt::poses::CPose3D(*record.robotPose);
        pose.pose.cov.setZero();
        m->rawlogFile->writeObject(pose);
    }
    if (m->imageFolder) {
        m->imageFolder->moveImagesOf(scan);
        m->rawlogFile->writeObject(scan);
    } else {
        const JpegScope jpeg;
        // A new image of the same pixels: one that came from a file would store its name instead.
        if (scan.intensityImage.isExternallyStored())
            scan.intensityImage =
                mrpt::img::CImage(scan.intensityImage.asCvMatRef(), mrpt::img::SHALLOW_COPY);
        m->rawlogFile->writeObject(scan);
    }
    if (!record.instances) return;
    if (m->options.embedInstances) {
        m->rawlogFile->writeObject(*record.instances);
    } else {
        if (!m->sidecarFile) m->sidecarFile.emplace(m->sidecar.part.string());
        m->sidecarFile->writeObject(*record.instances);
    }
}

void RgbdRawlogWriter::close()
{
    if (m->closed) return;
    m->rawlogFile->close();
    if (m->sidecarFile) m->sidecarFile->close();
    try {
        // What is left of an earlier rawlog of this name would be taken for a part of the new one.
        fs::remove(m->sidecar.target);
        fs::remove_all(m->images.target);
        if (m->imageFolder) m->images.putInPlace();
        if (m->sidecarFile) m->sidecar.putInPlace();
        m->rawlog.putInPlace();
    } catch (const fs::filesystem_error& e) {
        throw OutputError("cannot replace " + m->rawlog.target.string() + ": " +
                          e.code().message());
    }
    m->closed = true;
}
}  // namespace voxeland
