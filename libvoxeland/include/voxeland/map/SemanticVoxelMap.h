// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evidence/Dirichlet.h"
#include "voxeland/evidence/OccupancyFilter.h"
#include "voxeland/grid/BlockMap.h"
#include "voxeland/map/Calibration.h"
#include "voxeland/map/Instance.h"
#include "voxeland/map/MapBlock.h"

#include <map>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace mrpt::serialization
{
class CArchive;
}

namespace voxeland
{
/** Parameters of a map that do not change while it lives. */
struct MapOptions
{
    double resolution = 0.05;            //!< voxel edge [m], > 0
    OccupancyFilter::Options occupancy;  //!< of the binary Bayes filter
    double membership =
        0.25;  //!< a voxel is part of an instance if that has at least this share of what
               //!< speaks for instances there, in [0,1]; 0: a single vote does
    double prior_strength = 0.3;  //!< W: W/K is added to each of K known categories
    EntropyMeasure entropy = EntropyMeasure::expected;  //!< the measure used by queries
    uint32_t views_kept = 8;  //!< views an instance keeps of each category it was taken for
};

/** The probabilistic, instance-aware semantic voxel map (paper, "Map Representation"): occupancy
 * and a Dirichlet over instances per voxel, a Dirichlet over categories per instance. State only:
 * how frames become evidence is the pipeline's business. Copyable.
 *
 *  Frames of reference, both in metres: poses and answers are in the *world* of the poses it was
 *  built with. Voxels, and what is kept with them, are in the *map's frame*: the world's axes about
 *  origin(), which is the world's own origin unless the map lies too far from it for the numbers of
 *  voxels and the digits of floats. */
class SemanticVoxelMap
{
 public:
    /** Throws std::invalid_argument for options out of range. */
    explicit SemanticVoxelMap(const MapOptions& options = MapOptions());

    [[nodiscard]] const MapOptions& options() const { return m_options; }
    /** Changes the options that only queries use (prior, entropy) and how many views are kept from
     * now on, and all of them while the map is empty. \throws std::invalid_argument for options out
     * of range, or another resolution or occupancy model than the map was built with */
    void setOptions(const MapOptions& options);
    [[nodiscard]] double resolution() const { return m_options.resolution; }
    [[nodiscard]] const OccupancyFilter& occupancyFilter() const { return m_filter; }
    [[nodiscard]] bool empty() const { return m_blocks.size() == 0; }

    /** The origin of the map's frame, in the world [m]: a corner of a block of voxels, so that the
     *  raster of the voxels is the same for any origin. */
    [[nodiscard]] const mrpt::math::TPoint3D& origin() const { return m_origin; }
    /** Chooses the origin of an empty map, and leaves that of any other: along each axis, 0 where
     * that leaves room for half of all voxels beyond the place, or else the block's corner nearest
     * to it. \param place in the world [m], such as that of the first pose */
    void placeNear(const mrpt::math::TPoint3D& place);
    [[nodiscard]] mrpt::math::TPoint3D inMap(const mrpt::math::TPoint3D& inWorld) const
    {
        return inWorld - m_origin;
    }
    [[nodiscard]] mrpt::math::TPoint3D inWorld(const mrpt::math::TPoint3D& inMap) const
    {
        return inMap + m_origin;
    }
    void clear();

    /** \name Voxels
     * @{ */
    [[nodiscard]] const BlockMap<MapBlock>& blocks() const { return m_blocks; }
    [[nodiscard]] BlockMap<MapBlock>& blocks() { return m_blocks; }

    /** The voxel that holds a point of the map's frame [m].
     *  \throws ConfigurationError if the point is farther off than a map of this resolution can
     *  hold, or no numbers */
    [[nodiscard]] VoxelCoord voxelOf(const mrpt::math::TPoint3D& p) const;
    /** Occupancy at a point of the map's frame; UNOBSERVED where nothing is known, and wherever
     * voxelOf() throws.
     */
    [[nodiscard]] log_odds_t occupancyAt(const mrpt::math::TPoint3D& p) const;
    /** Occupancy of a voxel; UNOBSERVED where nothing is known. */
    [[nodiscard]] log_odds_t occupancy(const VoxelCoord& v) const;
    /** Evidence of a voxel, or null where no point was ever measured. */
    [[nodiscard]] const VoxelEvidence* evidence(const VoxelCoord& v) const;
    /** Adds evidence for an instance (or UNKNOWN_INSTANCE) to a voxel. \param alpha what is not > 0
     *  (discounted until nothing is left, say) or not finite is no evidence: nothing changes */
    void addEvidence(const VoxelCoord& v, instance_id_t instance, float alpha);

    /** Calls f(instance) for each instance that a voxel with this evidence is part of (see
     *  MapOptions::membership), ordered by id; not for *unknown*. */
    template <typename F>
    void forEachMember(const VoxelEvidence& evidence, F&& f) const
    {
        const float least = evidence.membershipThreshold(m_options.membership);
        for (const auto& e : evidence)
            if (e.instance != UNKNOWN_INSTANCE && e.alpha >= least) f(e.instance);
    }

    /** Calls f(VoxelCoord, occupancy, const VoxelEvidence&) for every surface voxel, ordered by
     *  coordinates of block and cell.
     *  \param occupiedOnly leave out voxels that are now more likely free than occupied */
    template <typename F>
    void forEachVoxel(F&& f, bool occupiedOnly = true) const
    {
        for (const uint32_t b : m_blocks.sorted()) {
            const MapBlock& block = m_blocks[b];
            block.forEachSurface([&](int cell, const VoxelEvidence& evidence) {
                const log_odds_t o = block.occupancy(cell);
                if (!occupiedOnly || OccupancyFilter::isOccupied(o))
                    f(voxelAt(m_blocks.coordOf(b), cell), o, evidence);
            });
        }
    }
    /** @} */

    /** \name Instances (*unknown* is not one of them)
     * @{ */
    [[nodiscard]] const std::map<instance_id_t, Instance>& instances() const { return m_instances; }
    /** A live instance by its id; throws std::out_of_range if there is none. */
    [[nodiscard]] Instance& instance(instance_id_t id) { return m_instances.at(id); }
    [[nodiscard]] const Instance& instance(instance_id_t id) const { return m_instances.at(id); }
    /** The live instance an id stands for now: itself, the survivor of merges, or UNKNOWN_INSTANCE
     * if it never existed. */
    [[nodiscard]] instance_id_t resolve(instance_id_t id) const;

    /** A new instance without evidence. Ids are never reused. */
    Instance& createInstance();
    /** Gives all of `absorbed`'s evidence to `survivor`; the absorbed id resolves to the survivor
     *  from then on. Cost: the blocks of the absorbed instance. \param frame after which it happens
     */
    void merge(instance_id_t survivor, instance_id_t absorbed, uint32_t frame);
    /** Makes a new instance of some voxels of an instance: their evidence for it moves, and the
     *  share `categoryShare` in [0,1] of the opinions about its category and of its number of
     * observations (rounded). A view goes to the part that is nearer to what it looked at. \param
     * frame after which it happens \return the new instance */
    Instance& split(instance_id_t from, const std::vector<VoxelCoord>& voxels, double categoryShare,
                    uint32_t frame);
    /** Notes that a frame, or one after it, saw an instance last. */
    void saw(instance_id_t id, uint32_t frame);
    /** Instances whose last frame is this one or a later one, ordered by id. Cost: those, however
     * many others there are. */
    [[nodiscard]] std::vector<instance_id_t> seenSince(uint32_t frame) const;
    /** Keeps an instance's record, but shows it as *unknown*: too little speaks for it. */
    void deactivate(instance_id_t id);
    /** Takes deactivate() back. */
    void reactivate(instance_id_t id) { m_inactive.erase(id); }
    [[nodiscard]] bool isInactive(instance_id_t id) const { return m_inactive.count(id) != 0; }
    [[nodiscard]] std::set<instance_id_t> inactive() const
    {
        return {m_inactive.begin(), m_inactive.end()};
    }
    /** The instance that most evidence of a voxel speaks for, inactive ones aside;
     *  UNKNOWN_INSTANCE where none does. */
    [[nodiscard]] instance_id_t winner(const VoxelEvidence& evidence) const
    {
        const instance_id_t first = evidence.strongest();
        return isInactive(first) ? winnerOfTheRest(evidence) : first;
    }
    /** @} */

    /** \name Categories
     * @{ */
    [[nodiscard]] const CategoryTable& categories() const { return m_categories; }
    [[nodiscard]] CategoryTable& categories() { return m_categories; }
    /** What the detector's words mean. The opinions are kept as they are, so that it can be changed
     * at any time. */
    [[nodiscard]] const Calibration& calibration() const { return m_calibration; }
    void setCalibration(Calibration calibration) { m_calibration = std::move(calibration); }
    /** beta of an instance's Dirichlet over categories: what the opinions about it mean, and
     * decisions. */
    [[nodiscard]] CategoryEvidence categoryEvidence(const Instance& instance) const;
    /** @} */

    /** Memory of the voxels. */
    struct Memory
    {
        size_t bytes = 0;          //!< of all blocks, allocator overhead included
        size_t evidenceBytes = 0;  //!< the part of it that surface voxels need on top of occupancy
        size_t observedVoxels = 0, surfaceVoxels = 0;

        /** Average of a voxel whose occupancy alone is known [bytes]. */
        [[nodiscard]] double bytesPerFreeVoxel() const;
        /** Average of a voxel with evidence for instances, its occupancy included [bytes]. */
        [[nodiscard]] double bytesPerSurfaceVoxel() const;
    };
    [[nodiscard]] Memory memory() const;

    /** The whole state, in an order that depends on the content alone. */
    void writeTo(mrpt::serialization::CArchive& out) const;
    /** Replaces this map by one written with writeTo(); throws std::exception on malformed input.
     */
    void readFrom(mrpt::serialization::CArchive& in);

 private:
    /** Changes a voxel's evidence and keeps the instances' numbers of voxels right.
     *  \param change called as change(evidence) */
    template <typename Change>
    void changeEvidence(VoxelEvidence& evidence, Change&& change);
    /** Moves an instance's evidence in one voxel. */
    void moveEvidence(MapBlock& block, const VoxelCoord& blockCoord, int cell, instance_id_t from,
                      instance_id_t to);
    /** Centres of all voxels with evidence for an instance [m]. */
    [[nodiscard]] std::vector<mrpt::math::TPoint3Df> centersOf(const Instance& instance) const;

    [[nodiscard]] instance_id_t winnerOfTheRest(const VoxelEvidence& evidence) const;

    MapOptions m_options;
    OccupancyFilter m_filter;
    mrpt::math::TPoint3D m_origin;  //!< in the world [m]
    BlockMap<MapBlock> m_blocks;
    std::map<instance_id_t, Instance> m_instances;
    std::map<instance_id_t, instance_id_t> m_absorbed;  //!< id -> instance that took its evidence
    std::unordered_set<instance_id_t> m_inactive;
    std::set<std::pair<uint32_t, instance_id_t>> m_byLastFrame;  //!< all live instances
    instance_id_t m_nextInstance = 1;
    CategoryTable m_categories;
    Calibration m_calibration;
};
}  // namespace voxeland
