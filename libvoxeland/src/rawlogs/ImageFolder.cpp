// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFolder.h"

#include "files/writeFailure.h"
#include "voxeland/base/errors.h"

#include <mrpt/core/format.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/system/filesystem.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** Number of bytes a gzip file unpacks to (modulo 2^32), as its last four bytes say. */
uint32_t unpackedSize(const fs::path& file)
{
    std::array<uint8_t, 4> b{};
    std::ifstream in(file, std::ios::binary);
    in.seekg(-static_cast<std::streamoff>(b.size()), std::ios::end);
    in.read(reinterpret_cast<char*>(b.data()), b.size());
    if (!in) return 0;
    return static_cast<uint32_t>(b[0]) | static_cast<uint32_t>(b[1]) << 8 |
           static_cast<uint32_t>(b[2]) << 16 | static_cast<uint32_t>(b[3]) << 24;
}
}  // namespace

ImageFolder::ImageFolder(fs::path folder, fs::path told)
    : m_folder(std::move(folder)), m_told(std::move(told))
{
    std::error_code error;
    fs::create_directory(m_folder, error);
    if (error) failToWrite(m_told.string(), error.value());
}

/** \param file in the folder, which errno is about */
void ImageFolder::fail(const fs::path& file) const
{
    failToWrite((m_told / file.filename()).string(), errno);
}

void ImageFolder::writeJpeg(const cv::Mat& image, const fs::path& file) const
{
    std::vector<uint8_t> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, JPEG_QUALITY});
    errno = 0;
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) fail(file);
}

void ImageFolder::moveImagesOf(mrpt::obs::CObservation3DRangeScan& scan)
{
    const std::string stem = mrpt::system::fileNameStripInvalidChars(mrpt::format(
        "3DCAM_%s_%f", scan.sensorLabel.c_str(), mrpt::Clock::toDouble(scan.timestamp)));
    if (scan.hasIntensityImage) moveColour(scan, stem + "_INT");
    if (scan.hasRangeImage) moveRanges(scan, stem + "_RANGES");
}

void ImageFolder::moveColour(mrpt::obs::CObservation3DRangeScan& scan,
                             const std::string& stem) const
{
    mrpt::img::CImage& image = scan.intensityImage;
    const fs::path source = image.isExternallyStored()
                                ? fs::path(image.getExternalStorageFileAbsolutePath())
                                : fs::path();
    // An image that is a file already keeps its bytes: no second loss by encoding it again.
    const fs::path target =
        m_folder / (stem + (source.empty() ? ".jpg" : source.extension().string()));
    if (source.empty()) {
        writeJpeg(image.asCvMatRef(), target);
    } else {
        std::error_code error;
        fs::copy_file(source, target, fs::copy_options::overwrite_existing, error);
        if (error)
            throw OutputError("cannot copy " + source.string() + " to " + m_told.string() + ": " +
                              error.message());
    }
    image = mrpt::img::CImage();
    image.setExternalStorage(target.filename().string());
}

void ImageFolder::moveRanges(mrpt::obs::CObservation3DRangeScan& scan,
                             const std::string& stem) const
{
    const fs::path file = m_folder / (stem + ".bin");
    const auto bytes =
        2 * sizeof(uint32_t) + static_cast<size_t>(scan.rangeImage.size()) * sizeof(uint16_t);
    const std::string basePath = mrpt::img::CImage::getImagesPathBase();
    errno = 0;
    try {
        scan.rangeImage_convertToExternalStorage(file.filename().string(), m_folder.string());
    } catch (const std::exception&) {
        mrpt::img::CImage::setImagesPathBase(basePath);  // MRPT leaves it changed
        fail(file);
    }
    // MRPT does not notice a disk that is full when the file is closed.
    if (unpackedSize(file) != static_cast<uint32_t>(bytes)) fail(file);
}
}  // namespace voxeland
