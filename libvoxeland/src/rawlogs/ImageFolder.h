// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace cv
{
class Mat;
}

namespace voxeland
{
constexpr int JPEG_QUALITY = 95;  //!< of colour images in rawlogs; MRPT's own default

/** The images of a rawlog as files of their own, named as MRPT's programs name them:
 *  3DCAM_LABEL_TIME_INT.jpg and 3DCAM_LABEL_TIME_RANGES.bin. */
class ImageFolder
{
 public:
    /** Creates the folder.
     *  \param told its name in messages, where its own is a temporary one
     *  \throws OutputError if that is not possible */
    ImageFolder(std::filesystem::path folder, std::filesystem::path told);

    /** Moves the scan's colour and range images to files and leaves references to them.
     *  \throws OutputError if they cannot be written */
    void moveImagesOf(mrpt::obs::CObservation3DRangeScan& scan);

 private:
    [[noreturn]] void fail(const std::filesystem::path& file) const;
    void writeJpeg(const cv::Mat& image, const std::filesystem::path& file) const;
    void moveColour(mrpt::obs::CObservation3DRangeScan& scan, const std::string& stem) const;
    void moveRanges(mrpt::obs::CObservation3DRangeScan& scan, const std::string& stem) const;

    std::filesystem::path m_folder, m_told;
};
}  // namespace voxeland
