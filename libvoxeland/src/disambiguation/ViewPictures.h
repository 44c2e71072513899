// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "UncertainInstance.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <functional>
#include <string>
#include <vector>

namespace cv
{
class Mat;
}

namespace voxeland
{
/** How sharp a BGR image is: variance of its Laplacian over that of its intensities (Pech-Pacheco
 * et al. 2000), so contrast does not count, at a size of 128 pixels. 0 for a uniform image. */
float sharpnessOf(const cv::Mat& image);

/** Fetches the pictures of all views from the rawlog the map was made from: the object with a
 * margin, outlined by its mask if the predictions are there, by its box otherwise; and tells how
 * sharp they are.
 *  \param config what the map was made with
 *  \param progress called with the share of the rawlog read, in [0,1]
 *  \return number of views whose frame the rawlog does not hold
 *  \throws InputError if it holds none of them, or others of the same time: it is another rawlog */
size_t fetchPictures(std::vector<UncertainInstance>& instances, const std::string& rawlog,
                     const MapperConfig& config, const std::function<void(double)>& progress);
}  // namespace voxeland
