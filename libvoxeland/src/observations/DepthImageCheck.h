// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace mrpt::obs
{
class CObservation;
class CObservation3DRangeScan;
}  // namespace mrpt::obs

namespace voxeland
{
/** What to call a frame in messages. */
std::string frameName(const mrpt::obs::CObservation& observation);

/** \throws UnusableFrame, naming the frame, for scans without a depth image or with invalid
 *  calibration or units */
void checkDepthImage(const mrpt::obs::CObservation3DRangeScan& scan);
}  // namespace voxeland
