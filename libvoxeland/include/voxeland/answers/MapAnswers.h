// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/OrientedBox.h"
#include "voxeland/map/MapQueries.h"
#include "voxeland/pipeline/SemanticMapper.h"

#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** A map in a few numbers. */
struct MapOverview
{
    double resolution = 0;  //!< voxel edge [m]
    mrpt::math::TPoint3D boxMin,
        boxMax;                 //!< around the occupied voxels [m]; equal if there is none
    size_t observedVoxels = 0;  //!< whose occupancy is known, free ones included
    size_t occupiedVoxels = 0;  //!< surface voxels now more likely occupied than free
    size_t instances = 0;       //!< that win at least one occupied voxel
    size_t inactive = 0;        //!< instances of too little evidence, shown as *unknown*
    std::map<std::string, unsigned> categories;  //!< those instances, by most probable category
    SemanticVoxelMap::Memory memory;
    MappingCounts counts;  //!< of the frames it was built from
};
MapOverview overviewOf(const SemanticVoxelMap& map, const MappingCounts& counts);

/** An instance that was looked for. */
struct FoundInstance
{
    InstanceSummary summary;
    OrientedBox box;
    double distance = 0;  //!< from where it was looked for to its centroid [m]
};

/** All instances with an occupied voxel: those of most voxels first, the surer first of equals. */
std::vector<FoundInstance> listInstances(const SemanticVoxelMap& map);
/** The same. \param frame tells where up is; estimateUp() otherwise */
std::vector<FoundInstance> listInstances(const SemanticVoxelMap& map,
                                         const GravityAlignedFrame& frame);

/** Instances whose most probable category fits a name best (see NameFit): those called the same; if
 *  there is none, those of which it is the plural or singular; if there is none, those whose
 * category contains it ("table" finds "dining table"). The nearest first. \param from where to
 * measure distances from [m] \throws ConfigurationError if that is out of the map's range */
std::vector<FoundInstance> findInstances(const SemanticVoxelMap& map, const std::string& category,
                                         const mrpt::math::TPoint3D& from);

/** Everything a map says of one place. */
struct PlaceAnswer
{
    mrpt::math::TPoint3D center;  //!< of the voxel that holds the place [m]
    bool observed = false;        //!< whether its occupancy is known
    double occupancy = 0.5;       //!< probability
    /** An instance the place may belong to. */
    struct InstanceShare
    {
        instance_id_t id = UNKNOWN_INSTANCE;
        std::string category;    //!< its most probable one
        double alpha = 0;        //!< evidence: weighted number of points
        double probability = 0;  //!< p(I_v = id | z)
    };
    std::vector<InstanceShare> instances;  //!< the most probable first; empty: nothing measured
    /** Object with the nearest occupied voxel, where no object has evidence at the place. */
    struct NearestObject
    {
        instance_id_t id = UNKNOWN_INSTANCE;
        std::string category;  //!< its most probable one
        double distance = 0;   //!< from the place to the centre of that voxel [m]
    };
    std::optional<NearestObject> nearest;
    std::vector<RankedCategory> categories;  //!< by total probability, the most probable first
    double instanceEntropy = 0, winnerCategoryEntropy = 0, categoryEntropy = 0;  //!< [nat]
};
/** One look-up, and a pass over the map where no object has evidence at the place.
 *  \throws ConfigurationError if the place is out of the map's range */
PlaceAnswer askPlace(const SemanticVoxelMap& map, const mrpt::math::TPoint3D& place);
}  // namespace voxeland
