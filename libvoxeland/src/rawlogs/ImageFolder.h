// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
constexpr int JPEG_QUALITY = 95;  //!< of colour images in rawlogs; MRPT's own default

/** The images of a rawlog as files of their own, named as MRPT's programs name them:
 *  3DCAM_LABEL_TIME_INT.jpg and 3DCAM_LABEL_TIME_RANGES.bin. */
class ImageFolder
{
 public:
    /** Creates the folder. \throws OutputError if that is not possible */
    explicit ImageFolder(std::filesystem::path folder);

    /** Moves the scan's colour and range images to files and leaves references to them.
     *  \throws OutputError if they cannot be written */
    void moveImagesOf(mrpt::obs::CObservation3DRangeScan& scan);

 private:
    void moveColour(mrpt::obs::CObservation3DRangeScan& scan, const std::string& stem) const;
    void moveRanges(mrpt::obs::CObservation3DRangeScan& scan, const std::string& stem) const;

    std::filesystem::path m_folder;
};
}  // namespace voxeland
