// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"
#include "voxeland/observations/PoseUncertainty.h"

#include <mrpt/poses/CPose3D.h>

#include <memory>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** One frame with all that is needed to map it. */
struct RgbdFrame
{
    std::shared_ptr<const mrpt::obs::CObservation3DRangeScan> scan;  //!< depth and colour; not null
    std::shared_ptr<const CObservationInstances>
        instances;                    //!< its predictions; null if there are none
    mrpt::poses::CPose3D robotPose;   //!< of the robot in the map's frame of reference
    PoseCovariance poseCovariance{};  //!< of robotPose; null if none is known
    /** Elapsed time that the predictions took, if they were made now and not recorded [s]. */
    double detectionTime = 0;
};

/** Whether rotation and translation are numbers, and a voxel of 1 mm at that place could be stored.
 */
bool isValidPose(const mrpt::poses::CPose3D& pose);
}  // namespace voxeland
