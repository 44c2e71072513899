// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CLoadableOptions.h>

#include <cstdint>

namespace mrpt::serialization
{
class CArchive;
}

namespace voxeland
{
/** How likely an observation is in a CVoxelandMap: a likelihood field (Thrun, Burgard and Fox,
 * "Probabilistic Robotics", 6.4). With d the distance from a measured point to the centre of the
 * nearest occupied voxel, capped at max_corr_distance, a point's likelihood is
 *
 *      (1 - outliers) exp(-d² / (2 sigma_dist²)) + outliers
 *
 *  and an observation's log-likelihood is the sum of its n points' logarithms, times
 *  independent_points / n where n is more than that. It is 0 at best, and 0 for an observation
 * without any point, which tells nothing. Voxels that are free and voxels never observed count the
 * same: not occupied. Measured points count, not what their rays pass through.
 *
 *  In an INI for MRPT's programs: section `<prefix>_voxelandMap_00_likelihoodOpts`. */
struct LikelihoodOptions : public mrpt::config::CLoadableOptions
{
    /** Standard deviation of d: of the sensor, the voxels and the map's poses together [m]. */
    double sigma_dist = 0.1;
    /** Largest distance that tells something, at most 99 voxels [m]. */
    double max_corr_distance = 0.3;
    /** Share of measured points that come from nothing in the map, in (0,1). */
    double outliers = 0.05;
    /** Points used of an observation, spread evenly over it; 0: all. */
    uint32_t max_points = 400;
    /** The points of an observation share the errors of the map and of the sensor's pose, so that
     *  they tell no more than so many independent ones would; 0: all are independent. */
    uint32_t independent_points = 40;
    /** Points farther from the sensor are left out [m]; 0: none. */
    double max_range = 0;

    /** Sets what the section names. \throws ConfigurationError for an unknown key or a value out of
     * range */
    void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                            const std::string& section) override;
    void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                          const std::string& section) const override;
    /** Prints a section that can be read back, with comments. */
    void dumpToTextStream(std::ostream& out) const override;

    void writeTo(mrpt::serialization::CArchive& out) const;
    void readFrom(mrpt::serialization::CArchive& in);
};
}  // namespace voxeland
