// SPDX-License-Identifier: BSD-3-Clause
#include "ImagePaths.h"

#include "files/NamedFile.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace voxeland
{
void checkImagePaths(const mrpt::obs::CObservation3DRangeScan& scan, const std::string& rawlog,
                     bool trusted)
{
    if (trusted) return;
    const auto check = [&](const std::string& file) {
        static_cast<void>(namedFile(mrpt::img::CImage::getImagesPathBase(), file, rawlog,
                                    Links::staysInside, false));
    };
    for (const mrpt::img::CImage* image : {&scan.intensityImage, &scan.confidenceImage})
        if (image->isExternallyStored()) check(image->getExternalStorageFileAbsolutePath());
    if (scan.points3D_isExternallyStored())
        check(scan.points3D_getExternalStorageFileAbsolutePath());
    if (!scan.rangeImage_isExternallyStored()) return;
    check(scan.rangeImage_getExternalStorageFileAbsolutePath(""));
    for (const auto& [layer, image] : scan.rangeImageOtherLayers)
        check(scan.rangeImage_getExternalStorageFileAbsolutePath(layer));
}
}  // namespace voxeland
