// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/RgbdFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voxeland::test
{
/** Depth of a pixel [m]; 0: not measured. */
using DepthOfPixel = std::function<double(int column, int row)>;

/** Shape of the made-up RGB-D camera: 80x60 pixels, a right angle wide. */
constexpr int COLUMNS = 80, ROWS = 60;
constexpr double FOCAL = 40, CENTER_X = 39.5, CENTER_Y = 29.5;

/** A depth scan in millimetres, at `seconds` since 1970, looking along the robot's x axis. */
std::shared_ptr<mrpt::obs::CObservation3DRangeScan> makeScan(const DepthOfPixel& depth,
                                                             double seconds = 1);

/** A mask of the columns [left, right) and rows [top, bottom). */
RunLengthMask rectangleMask(int left, int top, int right, int bottom, int width = COLUMNS,
                            int height = ROWS);

/** One detection of one category. */
InstancePrediction prediction(RunLengthMask mask, const std::string& category, float score = 1);

/** Predictions for the made-up camera. */
std::shared_ptr<CObservationInstances> makePredictions(std::vector<InstancePrediction> instances,
                                                       double seconds = 1);
}  // namespace voxeland::test
