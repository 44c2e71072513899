// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"

#include <cmath>

namespace voxeland::test
{
std::shared_ptr<mrpt::obs::CObservation3DRangeScan> makeScan(const DepthOfPixel& depth,
                                                             double seconds)
{
    auto scan = std::make_shared<mrpt::obs::CObservation3DRangeScan>();
    scan->timestamp = mrpt::Clock::fromDouble(seconds);
    scan->sensorLabel = "camera";
    scan->cameraParams.ncols = COLUMNS;
    scan->cameraParams.nrows = ROWS;
    scan->cameraParams.setIntrinsicParamsFromValues(FOCAL, FOCAL, CENTER_X, CENTER_Y);
    scan->cameraParamsIntensity = scan->cameraParams;
    scan->relativePoseIntensityWRTDepth = mrpt::poses::CPose3D(0, 0, 0, -M_PI / 2, 0, -M_PI / 2);
    scan->hasRangeImage = true;
    scan->rangeUnits = 0.001F;
    scan->range_is_depth = true;
    scan->rangeImage_setSize(ROWS, COLUMNS);
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column)
            scan->rangeImage(row, column) =
                static_cast<uint16_t>(std::lround(1000 * depth(column, row)));
    return scan;
}

RunLengthMask rectangleMask(int left, int top, int right, int bottom, int width, int height)
{
    std::vector<uint8_t> pixels(static_cast<size_t>(width) * static_cast<size_t>(height), 0);
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column)
            pixels[static_cast<size_t>(row * width + column)] = 1;
    return RunLengthMask::fromBitmap(pixels.data(), width, height);
}

InstancePrediction prediction(RunLengthMask mask, const std::string& category, float score)
{
    InstancePrediction p;
    p.box = mask.boundingBox();
    p.mask = std::move(mask);
    p.categories = {{category, 1}};
    p.score = score;
    return p;
}

std::shared_ptr<CObservationInstances> makePredictions(std::vector<InstancePrediction> instances,
                                                       double seconds)
{
    auto observation = std::make_shared<CObservationInstances>();
    observation->timestamp = mrpt::Clock::fromDouble(seconds);
    observation->sensorLabel = "detector";
    observation->imageWidth = COLUMNS;
    observation->imageHeight = ROWS;
    observation->instances = std::move(instances);
    return observation;
}
}  // namespace voxeland::test
