// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/ColourImage.h"

#include "DepthImageCheck.h"
#include "MaskCamera.h"
#include "files/PictureDecoders.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/files/InputFile.h"
#include "voxeland/observations/UnusableFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgproc.hpp>

#include <cerrno>

namespace voxeland
{
cv::Mat colourImage(const mrpt::obs::CObservation3DRangeScan& scan)
{
    if (!scan.hasIntensityImage) throw UnusableFrame(frameName(scan) + " has no colour image");
    constexpr uint64_t TIMES_THE_CAMERA = 16;
    const auto& camera = maskCamera(scan);
    const uint64_t oversizedBefore = oversizedPictures();
    cv::Mat image;
    errno = 0;
    try {
        const auto& stored = scan.intensityImage;
        if (stored.isExternallyStored())
            checkInputFile(stored.getExternalStorageFileAbsolutePath(), "the colour image");
        const PictureLimit limit(TIMES_THE_CAMERA * camera.ncols * camera.nrows);
        image = stored.asCvMat<cv::Mat>(mrpt::img::SHALLOW_COPY);
    } catch (const std::exception&) {
        RefusedMemory::noteErrno();
        image.release();
    }
    const std::string told = "the colour image of " + frameName(scan);
    if (oversizedPictures() != oversizedBefore)
        throw UnusableFrame(told +
                            " has too many pixels for its camera: restore the rawlog's "
                            "folder of images, or correct cameraParams");
    if (image.empty())
        throw UnusableFrame(told + " cannot be read: restore the rawlog's folder of images");
    if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
    if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
    return image;
}
}  // namespace voxeland
