// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/observations/RgbdFrame.h"
#include "voxeland/pipeline/SemanticMapper.h"

#include <string>
#include <vector>

namespace voxeland::benchmarks
{
/** Frames of 640x480 pixels with poses and predictions, decoded and in memory. Every benchmark
 *  works on one after another, so that what it reports is the mean of a frame. */
struct BenchmarkFrames
{
    std::string origin;  //!< what they show, for people
    std::vector<RgbdFrame> frames;
};

/** Frames of a real kitchen where that data is, of a simulated apartment elsewhere. */
const BenchmarkFrames& benchmarkFrames();

/** A mapper with the default configuration. */
SemanticMapper defaultMapper();

/** All frames, prepared for mapping. */
const std::vector<PreparedFrame>& preparedFrames();

/** The map of all frames. */
const SemanticVoxelMap& filledMap();
}  // namespace voxeland::benchmarks
