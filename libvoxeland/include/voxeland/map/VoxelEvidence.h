// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <cstring>
#include <memory>

namespace voxeland
{
/** Identity of an object instance in a map: 1, 2, ... in order of appearance, never reused. */
using instance_id_t = uint32_t;

/** The *unknown* instance: what no detection speaks for. */
inline constexpr instance_id_t UNKNOWN_INSTANCE = 0;

/** Concentration parameters alpha_k of one voxel's Dirichlet distribution over instances (paper,
 *  "Map Representation"): the weighted number of 3D points of instance k that fell in the voxel.
 *  Instances without evidence are not stored; entries are ordered by id. Room for four (unknown
 *  and three instances) is in place, more go to the heap: 40 bytes in all. */
class VoxelEvidence
{
 public:
    /** Evidence of one instance. */
    struct Entry
    {
        instance_id_t instance = UNKNOWN_INSTANCE;
        float alpha = 0;  //!< weighted number of points, > 0
    };

    VoxelEvidence() = default;
    VoxelEvidence(const VoxelEvidence& other);
    VoxelEvidence(VoxelEvidence&& other) noexcept;
    VoxelEvidence& operator=(VoxelEvidence other) noexcept;
    ~VoxelEvidence();

    [[nodiscard]] const Entry* begin() const
    {
        return m_capacity > INLINE ? m_data.heap : m_data.here;
    }
    [[nodiscard]] const Entry* end() const { return begin() + m_size; }
    [[nodiscard]] uint32_t size() const { return m_size; }

    /** Adds evidence for an instance. \param alpha > 0 \return whether the instance is new here */
    bool add(instance_id_t instance, float alpha);
    /** Removes an instance's evidence. \return how much it had, 0 if none */
    float remove(instance_id_t instance);
    /** Evidence for an instance, 0 if none. */
    [[nodiscard]] float alphaOf(instance_id_t instance) const;

    /** Sum of all evidence. */
    [[nodiscard]] float total() const;
    /** Evidence that makes the voxel part of an instance: `share` of all that speaks for instances,
     * *unknown* aside. \param share in [0,1]; 0: any evidence does */
    [[nodiscard]] float membershipThreshold(double share) const;
    /** The instance with most evidence; among equals the one seen first, *unknown* last.
     * UNKNOWN_INSTANCE where there is no evidence. */
    [[nodiscard]] instance_id_t strongest() const;

    /** Heap memory in use [bytes]. */
    [[nodiscard]] size_t heapMemory() const
    {
        return m_capacity > INLINE ? m_capacity * sizeof(Entry) + 16 : 0;
    }

 private:
    static constexpr uint32_t INLINE = 4;

    [[nodiscard]] Entry* data() { return m_capacity > INLINE ? m_data.heap : m_data.here; }
    void grow();

    uint32_t m_size = 0, m_capacity = INLINE;
    union Data
    {
        Data() : here{} {}
        Entry here[INLINE];
        Entry* heap;
    } m_data;
};
}  // namespace voxeland
