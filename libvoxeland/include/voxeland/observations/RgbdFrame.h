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
        instances;  //!< its predictions; null if there are none
    mrpt::poses::CPose3D
        robotPose;  //!< of the robot, in the world, or the map's frame where it is to be prepared
    PoseCovariance poseCovariance{};  //!< of robotPose; null if none is known
    /** Elapsed time that the predictions took, if they were made now and not recorded [s]. */
    double detectionTime = 0;
};

/** Whether a pose is one of a rigid body: numbers, a rotation to within 0.01, and within 1e9 m,
 * where a coordinate still tells a tenth of a micrometre. Whether a map can hold what is seen from
 * there is up to the map. */
bool isValidPose(const mrpt::poses::CPose3D& pose);

/** A pose as seen from a point, without turning. */
mrpt::poses::CPose3D relativeTo(const mrpt::math::TPoint3D& origin,
                                const mrpt::poses::CPose3D& pose);
}  // namespace voxeland
