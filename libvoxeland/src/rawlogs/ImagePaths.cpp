// SPDX-License-Identifier: BSD-3-Clause
#include "ImagePaths.h"

#include "files/NamedFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <vector>

namespace voxeland
{
namespace
{
/** Names of the files that hold parts of a scan, as the scan has them. */
std::vector<std::string> externalNames(const mrpt::obs::CObservation3DRangeScan& scan)
{
    std::vector<std::string> names;
    for (const mrpt::img::CImage* image : {&scan.intensityImage, &scan.confidenceImage})
        if (image->isExternallyStored()) names.push_back(image->getExternalStorageFile());
    if (scan.points3D_isExternallyStored()) names.push_back(scan.points3D_getExternalStorageFile());
    if (scan.rangeImage_isExternallyStored())
        names.push_back(scan.rangeImage_getExternalStorageFile(""));
    return names;
}
}  // namespace

void checkImagePaths(const mrpt::obs::CObservation3DRangeScan& scan, const std::string& rawlog,
                     bool trusted)
{
    constexpr size_t SHORTEST = 3;  // for MRPT
    for (const std::string& name : externalNames(scan))
        if (name.size() < SHORTEST)
            throw InputError("'" + rawlog + "' names '" + printable(name) +
                             "' as the file of an image or of points, and no name of fewer than 3 "
                             "characters is one: make the rawlog anew");
    const auto check = [&](const std::string& file) {
        static_cast<void>(namedFile(mrpt::img::CImage::getImagesPathBase(), file, rawlog,
                                    Links::staysInside, trusted));
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
