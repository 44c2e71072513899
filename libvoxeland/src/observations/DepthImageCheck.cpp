// SPDX-License-Identifier: BSD-3-Clause
#include "DepthImageCheck.h"

#include "CameraCheck.h"
#include "MaskCamera.h"
#include "base/sizeText.h"
#include "base/timeText.h"
#include "voxeland/base/numbers.h"
#include "voxeland/observations/UnusableFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>

using mrpt::img::TCamera;
using mrpt::obs::CObservation3DRangeScan;

namespace voxeland
{
namespace
{
/** Whether a coordinate of the principal point may be one of an image that long: not at its border,
 *  where that of an image of twice the size lies. */
bool isWellInside(double coordinate, unsigned pixels)
{
    constexpr double BORDER = 0.1;
    return coordinate > BORDER * pixels && coordinate < (1 - BORDER) * pixels;
}
}  // namespace

std::string frameName(const mrpt::obs::CObservation& o)
{
    return "frame '" + o.sensorLabel + "' of " + timeText(o.timestamp);
}

void checkDepthImage(const CObservation3DRangeScan& scan)
{
    if (!scan.hasRangeImage)
        throw UnusableFrame(frameName(scan) +
                            " has no depth image: only scans with one can be mapped");
    const auto& image = scan.rangeImage;
    const TCamera& camera = scan.cameraParams;
    if (image.size() == 0) throw UnusableFrame(frameName(scan) + " has an empty depth image");
    if (image.cols() != static_cast<int>(camera.ncols) ||
        image.rows() != static_cast<int>(camera.nrows))
        throw UnusableFrame(frameName(scan) + " has a depth image of " +
                            sizeText(image.cols(), image.rows()) +
                            " pixels but a calibration for " +
                            sizeText(camera.ncols, camera.nrows) + ": correct its cameraParams");
    if (!(scan.rangeUnits > 0 && std::isfinite(scan.rangeUnits)))
        throw UnusableFrame(frameName(scan) + " has a depth unit of " +
                            numberText(static_cast<double>(scan.rangeUnits)) +
                            " m: correct its rangeUnits");
    if (const auto problem = problemOf(camera); !problem.empty())
        throw UnusableFrame(frameName(scan) + " " + problem + ": correct its cameraParams");
    const TCamera& colour = maskCamera(scan);
    if (const auto problem = problemOf(colour); &colour != &camera && !problem.empty())
        throw UnusableFrame("the colour camera of " + frameName(scan) + " " + problem +
                            ": correct its cameraParamsIntensity");
    if (!isWellInside(camera.cx(), camera.ncols) || !isWellInside(camera.cy(), camera.nrows))
        throw UnusableFrame(frameName(scan) + " has a principal point at (" +
                            fixedText(camera.cx(), 1) + ", " + fixedText(camera.cy(), 1) +
                            ") of an image of " + sizeText(camera.ncols, camera.nrows) +
                            " pixels: its cameraParams are those of another size, correct them");
}
}  // namespace voxeland
