// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/DatasetCameras.h"

#include "base/sizeText.h"
#include "observations/CameraCheck.h"
#include "voxeland/base/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
constexpr float MAX_RANGE = 10;  // [m]; for viewers

constexpr double MOST_OFF_CENTRE = 0.25;  // of half the image, that no camera's centre exceeds
constexpr double RECORDED_OFF_CENTRE = 0.08;
constexpr double MOST_STRETCH = 0.02;  // 1296x968 to 640x480 is a stretch of 0.4 %

/** How far a camera's centre is from the middle of an image, as a share of half the image. */
double offCentre(const PinholeCamera& camera, const ImageSize& images)
{
    return std::max(std::abs(2 * (camera.cx + 0.5) / images.width - 1),
                    std::abs(2 * (camera.cy + 0.5) / images.height - 1));
}

std::string centreText(const PinholeCamera& camera)
{
    return "(" + std::to_string(std::lround(camera.cx)) + ", " +
           std::to_string(std::lround(camera.cy)) + ")";
}

/** Size of the images that a camera belongs to, as far as can be told: that of \p images unless
 *  its centre is clearly the middle of another. */
ImageSize sizeOf(const PinholeCamera& camera, const ImageSize& images,
                 const std::vector<ImageSize>& recordedSizes)
{
    if (camera.size.width > 0 && camera.size.height > 0) return camera.size;
    ImageSize best = images;
    for (const ImageSize& size : recordedSizes) {
        const double off = offCentre(camera, size);
        if (off <= RECORDED_OFF_CENTRE && off < offCentre(camera, best) / 2) best = size;
    }
    return best;
}

mrpt::img::TCamera cameraOf(const PinholeCamera& model, const ImageSize& images,
                            const std::string& which)
{
    if (!(model.cx > 0 && model.cx < images.width && model.cy > 0 && model.cy < images.height))
        throw InputError(which + " have " + images.text() +
                         " pixels, which does not fit a camera centred at " + centreText(model) +
                         ": correct the intrinsics, or use images of the original size");
    mrpt::img::TCamera camera;
    camera.ncols = static_cast<uint32_t>(images.width);
    camera.nrows = static_cast<uint32_t>(images.height);
    camera.setIntrinsicParamsFromValues(model.fx, model.fy, model.cx, model.cy);
    const auto& d = model.distortion;
    if (d != PinholeCamera().distortion) camera.setDistortionPlumbBob(d[0], d[1], d[2], d[3], d[4]);
    if (const auto problem = problemOf(camera); !problem.empty())
        throw InputError("the camera of " + which + " " + problem + ": correct the intrinsics");
    return camera;
}
}  // namespace

std::string ImageSize::text() const
{
    return sizeText(width, height);
}

DatasetCameras registeredCameras(const PinholeCamera& camera, double depthScale,
                                 const std::vector<ImageSize>& recordedSizes)
{
    return {camera, camera, true, depthScale, recordedSizes};
}

PinholeCamera fittedCamera(const PinholeCamera& camera, const ImageSize& images,
                           const std::vector<ImageSize>& recordedSizes, const std::string& which,
                           const std::string& option, std::vector<std::string>& notes)
{
    const ImageSize own = sizeOf(camera, images, recordedSizes);
    const std::string contradiction =
        which + " have " + images.text() + " pixels, but their camera ";
    PinholeCamera fitted = camera;
    fitted.size = images;
    if (own == images) {
        if (!(camera.size == images) && offCentre(camera, images) > MOST_OFF_CENTRE)
            throw InputError(contradiction + "is centred at " + centreText(camera) +
                             ", far from their middle: its intrinsics are of another size; give"
                             " those of these images with " +
                             option + " FX,FY,CX,CY");
        return fitted;
    }
    const double x = static_cast<double>(images.width) / own.width;
    const double y = static_cast<double>(images.height) / own.height;
    if (std::abs(x / y - 1) > MOST_STRETCH)
        throw InputError(contradiction + "is of " + own.text() +
                         ": whether they were cropped or stretched cannot be told; give their "
                         "intrinsics with " +
                         option + " FX,FY,CX,CY");
    fitted.fx *= x;
    fitted.fy *= y;
    fitted.cx = (camera.cx + 0.5) * x - 0.5;  // numbers of pixels are those of their middles
    fitted.cy = (camera.cy + 0.5) * y - 0.5;
    notes.push_back(contradiction + "is of " + own.text() + ": its intrinsics are scaled (" +
                    option + " gives others)");
    return fitted;
}

void calibrate(mrpt::obs::CObservation3DRangeScan& scan, const DatasetCameras& cameras)
{
    const auto& depth = scan.rangeImage;
    const auto& colour = scan.intensityImage;
    scan.sensorLabel = "RGBD";
    scan.range_is_depth = true;
    scan.rangeUnits = static_cast<float>(1 / cameras.depthScale);
    scan.maxRange = MAX_RANGE;
    scan.cameraParams =
        cameraOf(cameras.depth, {static_cast<int>(depth.cols()), static_cast<int>(depth.rows())},
                 "the depth images");
    scan.cameraParamsIntensity = cameraOf(
        cameras.colour, {static_cast<int>(colour.getWidth()), static_cast<int>(colour.getHeight())},
        "the colour images");
    using namespace mrpt::literals;
    scan.relativePoseIntensityWRTDepth = {0, 0, 0, -90.0_deg, 0.0_deg, -90.0_deg};
}
}  // namespace voxeland
