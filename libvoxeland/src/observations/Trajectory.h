// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/LeftOut.h"
#include "voxeland/observations/PoseTrack.h"

#include <string>
#include <vector>

namespace voxeland
{
/** A trajectory in the TUM format: lines `timestamp tx ty tz qx qy qz qw`, seconds and metres, or
 *  with these in the order that titles of columns say (EuRoC's ground truth, other CSV files), see
 *  TimedLines for what else is understood. Lines that give no pose (a number missing or not finite,
 *  a quaternion not of unit length) are left out. */
struct Trajectory
{
    PoseTrack poses;
    LeftOut leftOut;
    std::vector<std::string> notes;  //!< what was assumed or left out: sentences for the user

    /** \param maxGap longest time between two poses to interpolate over [s]
     *  \param strict lines that would be left out are errors
     *  \throws InputError, naming file and line, if it is missing, has decimal commas or no pose */
    static Trajectory fromTumFile(const std::string& file, double maxGap, bool strict = false);
};
}  // namespace voxeland
