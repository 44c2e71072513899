// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPoint3D.h>

#include <cstddef>
#include <vector>

namespace mrpt::obs
{
class CObservation;
}

namespace voxeland
{
/** Whether observedPoints() knows this kind of observation: CObservation2DRangeScan,
 *  CObservation3DRangeScan with a depth image or points, CObservationPointCloud,
 *  CObservationVelodyneScan. */
bool hasPoints(const mrpt::obs::CObservation& observation);

/** Points that a sensor measured, in the robot's frame [m].
 *
 *  Cheap enough to be asked again for every particle: of a depth image only the pixels wanted are
 * unprojected; a Velodyne scan keeps the points made of its packets. Parts that are stored outside
 * of the observation are loaded when they are not there yet, and stay. Points that are not finite,
 * as clouds have them for what was not measured, are left out.
 *
 *  \param most how many points to give at most, spread evenly over the observation; of a depth
 * image about as many; 0: all \param maxRange points farther from the sensor are left out [m]; 0:
 * none \throws InputError for a depth image without a valid calibration */
std::vector<mrpt::math::TPoint3D> observedPoints(const mrpt::obs::CObservation& observation,
                                                 size_t most, double maxRange);
}  // namespace voxeland
