// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <mrpt/img/TCamera.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/poses/CPose3D.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace voxeland
{
/** A pixel of a depth image. */
struct SampledPixel
{
    mrpt::math::TPoint2D direction;  //!< of its ray: x/z and y/z of optical axes
    double value = 0;                //!< in the image, > 0
};

/** Two frames that see a good part of the same place. */
struct FramePair
{
    std::vector<SampledPixel> first;  //!< the first one's pixels, on a grid
    std::shared_ptr<const mrpt::obs::CObservation3DRangeScan> second;
    mrpt::poses::CPose3D firstPose, secondPose;  //!< camera-to-world, of optical axes
};

/** Frames read to compare them. */
struct FrameSample
{
    std::vector<FramePair> pairs;
    std::map<std::string, size_t> unusable;  //!< number of frames that could not be read, by reason
};

/** Picks frames all over a dataset's selection, and for each of them, of some that follow, the one
 *  farthest away of those that look in a similar direction.
 *  \param progress called after each frame with the number read
 *  \throws InputError as the reader does */
FrameSample pickFramePairs(const RgbdDatasetReader& dataset,
                           const std::function<void(size_t read)>& progress);
}  // namespace voxeland
