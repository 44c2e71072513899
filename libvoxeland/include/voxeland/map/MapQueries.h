// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

#include <string>
#include <vector>

namespace voxeland
{
/** One category with its probability. */
struct RankedCategory
{
    category_id_t category = 0;
    std::string name;
    double probability = 0;
};

/** p(C_k|z) of an instance: the mean of its Dirichlet with the map's prior, the most probable
 * category first (ties by name). Categories without evidence are left out unless the prior gives
 * them some. */
std::vector<RankedCategory> categoryDistribution(const SemanticVoxelMap& map,
                                                 const Instance& instance);

/** H(C_k) of an instance [nat], by the map's entropy measure, with its prior. */
double categoryEntropy(const SemanticVoxelMap& map, const Instance& instance);

/** Share of an instance's opinion that rests on no evidence, W/(W+A); 0 if the map's prior is 0. */
double categoryVacuity(const SemanticVoxelMap& map, const Instance& instance);

/** p(I_v = winner | z) of a voxel, in [0,1]; inactive instances count for *unknown*. */
double winnerProbability(const SemanticVoxelMap& map, const VoxelEvidence& evidence);

/** H(I_v): entropy of a voxel's Dirichlet over instances, *unknown* included [nat]. */
double instanceEntropy(const SemanticVoxelMap& map, const VoxelEvidence& evidence);

/** What a map says of one object, in numbers a person wants to read. */
struct InstanceSummary
{
    instance_id_t id = UNKNOWN_INSTANCE;
    std::vector<RankedCategory> categories;  //!< as categoryDistribution()
    double entropy = 0;                      //!< categoryEntropy() [nat]
    double vacuity = 0;                      //!< categoryVacuity()
    double geometricEntropy = 0;             //!< mean instanceEntropy() over its voxels [nat]
    uint32_t observations = 0;               //!< number of opinions
    uint32_t voxels = 0;                     //!< occupied voxels where it wins
    mrpt::math::TPoint3D centroid;           //!< of those voxels' centres [m]
    mrpt::math::TPoint3D boxMin, boxMax;     //!< axis-aligned box around those voxels [m]

    /** Most probable category, or UNKNOWN_CATEGORY. */
    [[nodiscard]] std::string category() const
    {
        return categories.empty() ? UNKNOWN_CATEGORY : categories.front().name;
    }
    /** Its probability, 0 if there is none. */
    [[nodiscard]] double probability() const
    {
        return categories.empty() ? 0 : categories.front().probability;
    }
};

/** Summaries of all instances that win at least one occupied voxel, ordered by id; one pass over
 * the map. */
std::vector<InstanceSummary> summarizeInstances(const SemanticVoxelMap& map);

/** The voxels that each instance wins; *unknown* is among them.
 * \param occupiedOnly as in SemanticVoxelMap::forEachVoxel() */
std::map<instance_id_t, std::vector<VoxelCoord>> voxelsByWinner(const SemanticVoxelMap& map,
                                                                bool occupiedOnly = true);

/** Entropies of voxels; remembers each instance's category distribution, so that a pass over a
 * whole map is cheap. Holds a reference to the map, which must not change meanwhile. */
class VoxelUncertainty
{
 public:
    explicit VoxelUncertainty(const SemanticVoxelMap& map);

    /** p(C_v|z) by total probability over the voxel's instances, indexed by category id, the last
     *  entry being *unknown* (paper, "Building Uncertainty Maps"). Sums to 1. */
    [[nodiscard]] const std::vector<double>& categories(const VoxelEvidence& evidence);
    /** H(C_v): Shannon entropy of categories() [nat]. */
    [[nodiscard]] double categoryEntropy(const VoxelEvidence& evidence);
    /** H(I_v) [nat]. */
    [[nodiscard]] double instanceEntropy(const VoxelEvidence& evidence) const;
    /** H(C_k) of the instance that wins the voxel [nat]; 0 where that is *unknown*. */
    [[nodiscard]] double winnerCategoryEntropy(const VoxelEvidence& evidence) const;

 private:
    const SemanticVoxelMap& m_map;
    std::map<instance_id_t, std::vector<RankedCategory>> m_distributions;
    std::map<instance_id_t, double> m_entropies;
    std::vector<double> m_categories;
};
}  // namespace voxeland
