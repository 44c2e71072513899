// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "support/Frames.h"

#include <mrpt/obs/CObservationRobotPose.h>

#include <string>
#include <vector>

namespace voxeland::test
{
/** What a small rawlog holds of one frame: a box on a wall, seen by a moving camera. */
struct SmallFrame
{
    std::shared_ptr<mrpt::obs::CObservation3DRangeScan> scan;
    std::shared_ptr<CObservationInstances> instances;
    std::shared_ptr<mrpt::obs::CObservationRobotPose> pose;
};

/** Frames numbered from 0, ten a second. */
std::vector<SmallFrame> smallFrames(int count);

/** Writes frames as a rawlog of observations; parts that are null are left out.
 *  \param embed true: predictions inside, false: in the sidecar */
void writeRawlog(const std::string& file, const std::vector<SmallFrame>& frames,
                 bool embed = false);
}  // namespace voxeland::test
