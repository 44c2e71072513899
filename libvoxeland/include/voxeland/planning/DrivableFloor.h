// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/OrientedBox.h"

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <memory>
#include <vector>

namespace mrpt::maps
{
class COccupancyGridMap2D;
}

namespace voxeland
{
/** A robot that drives: an upright cylinder. */
struct DrivingRobot
{
    double radius = 0.25;    //!< [m]
    double clearance = 0.1;  //!< what is not higher above the floor it drives over [m]
    double height = 1.2;     //!< what is higher above the floor it drives under [m]
    double eyes = 1.0;       //!< height above the floor from which it looks at things [m]
    double reach = 0.8;      //!< farthest from its middle to a thing it stands before [m]
};

/** Where a robot can stand, in a gravity-aligned frame: its x and y, and yaw from x towards y. */
class DrivableFloor
{
 public:
    /** Keeps a reference to the map, which must not change meanwhile.
     *  \throws ConfigurationError if nothing was observed at the robot's heights */
    DrivableFloor(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                  const DrivingRobot& robot = DrivingRobot());

    /** The slice between the robot's clearance and height: what MRPT's planners plan in. */
    [[nodiscard]] const mrpt::maps::COccupancyGridMap2D& grid() const { return *m_grid; }
    /** Whether the robot fits there: every cell it covers was observed and is likelier free. */
    [[nodiscard]] bool fits(const mrpt::math::TPoint2D& at) const;
    /** Where the robot can stand right before an object and look at its middle: for each of 32
     *  directions the nearest place where it fits, at most touches the object's box, and nothing
     *  outside that box, such as a wall, hides its middle.
     *  \return those nearest to its middle first; none if there is no such place */
    [[nodiscard]] std::vector<mrpt::math::TPose2D> posesFacing(const OrientedBox& boxInWorld) const;

 private:
    [[nodiscard]] bool sees(const mrpt::math::TPoint2D& from, const OrientedBox& box) const;

    const SemanticVoxelMap& m_map;
    GravityAlignedFrame m_frame;
    DrivingRobot m_robot;
    double m_floor;  //!< its height in the gravity-aligned frame [m]
    std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> m_grid;
};
}  // namespace voxeland
