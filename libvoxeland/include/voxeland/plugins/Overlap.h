// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/Instance.h"
#include "voxeland/observations/Opinion.h"

#include <algorithm>
#include <vector>

namespace voxeland
{
/** Overlap of an opinion with one map instance, in numbers of distinct voxels. An instance's voxels
 * are all those with evidence for it. */
struct Overlap
{
    instance_id_t instance = UNKNOWN_INSTANCE;
    uint32_t intersection = 0;    //!< voxels of both
    uint32_t opinionVoxels = 0;   //!< voxels of the opinion
    uint32_t instanceVoxels = 0;  //!< voxels of the instance
    uint32_t visibleVoxels = 0;   //!< voxels of the instance that the camera sees now
    double similarity = 0;        //!< S_sem, see semanticSimilarity()

    /** Intersection over union, in [0,1]. */
    [[nodiscard]] double iou() const
    {
        return static_cast<double>(intersection) /
               static_cast<double>(opinionVoxels + instanceVoxels - intersection);
    }
    /** Intersection over visible, in [0,1] (paper, "Data Association"). */
    [[nodiscard]] double iov() const
    {
        return static_cast<double>(intersection) /
               static_cast<double>(std::max(visibleVoxels, intersection));
    }
};

/** An opinion with all map instances it overlaps, ordered by id. */
struct OpinionOverlaps
{
    const Opinion* opinion = nullptr;
    CategoryEvidence categories;  //!< the opinion's distribution, in the map's category numbers
    std::vector<Overlap> candidates;
};

/** Overlap of two map instances, in numbers of distinct voxels. */
struct InstanceOverlap
{
    instance_id_t a = UNKNOWN_INSTANCE, b = UNKNOWN_INSTANCE;  //!< a < b
    uint32_t intersection = 0, voxelsA = 0, voxelsB = 0;
    double similarity = 0;  //!< S_sem, see semanticSimilarity()

    [[nodiscard]] double iou() const
    {
        return static_cast<double>(intersection) /
               static_cast<double>(voxelsA + voxelsB - intersection);
    }
    /** Intersection over smaller, in [0,1] (paper, "Multi-instance Integration"). */
    [[nodiscard]] double ios() const
    {
        return static_cast<double>(intersection) / static_cast<double>(std::min(voxelsA, voxelsB));
    }
};
}  // namespace voxeland
