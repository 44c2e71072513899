// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/DatasetCameras.h"

#include "voxeland/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>

namespace voxeland
{
namespace
{
constexpr float MAX_RANGE = 10;  // [m]; for viewers

mrpt::img::TCamera cameraOf(const PinholeCamera& model, size_t width, size_t height,
                            const std::string& which)
{
    const auto columns = static_cast<double>(width), rows = static_cast<double>(height);
    if (!(model.cx > 0 && model.cx < columns && model.cy > 0 && model.cy < rows))
        throw InputError(which + " has " + std::to_string(width) + "x" + std::to_string(height) +
                         " pixels, which does not fit a camera centred at (" +
                         std::to_string(std::lround(model.cx)) + ", " +
                         std::to_string(std::lround(model.cy)) +
                         "): correct the intrinsics, or use images of the original size");
    mrpt::img::TCamera camera;
    camera.ncols = static_cast<uint32_t>(width);
    camera.nrows = static_cast<uint32_t>(height);
    camera.setIntrinsicParamsFromValues(model.fx, model.fy, model.cx, model.cy);
    const auto& d = model.distortion;
    if (d != PinholeCamera().distortion) camera.setDistortionPlumbBob(d[0], d[1], d[2], d[3], d[4]);
    return camera;
}
}  // namespace

DatasetCameras registeredCameras(const PinholeCamera& camera, double depthScale)
{
    return {camera, camera, true, depthScale};
}

void calibrate(mrpt::obs::CObservation3DRangeScan& scan, const DatasetCameras& cameras,
               const std::string& frame)
{
    const auto width = static_cast<size_t>(scan.rangeImage.cols());
    const auto height = static_cast<size_t>(scan.rangeImage.rows());
    const auto& colour = scan.intensityImage;
    if (cameras.registered && (colour.getWidth() != width || colour.getHeight() != height))
        throw InputError("the colour image " + frame + " and its depth image differ in size");

    scan.sensorLabel = "RGBD";
    scan.range_is_depth = true;
    scan.rangeUnits = static_cast<float>(1 / cameras.depthScale);
    scan.maxRange = MAX_RANGE;
    scan.cameraParams = cameraOf(cameras.depth, width, height, "the depth image of " + frame);
    scan.cameraParamsIntensity = cameraOf(cameras.colour, colour.getWidth(), colour.getHeight(),
                                          "the colour image " + frame);
    using namespace mrpt::literals;
    scan.relativePoseIntensityWRTDepth = {0, 0, 0, -90.0_deg, 0.0_deg, -90.0_deg};
}
}  // namespace voxeland
