// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/Instance.h"
#include "voxeland/observations/Opinion.h"

#include <algorithm>
#include <vector>

namespace voxeland
{
/** Overlap of an opinion with one map instance, in numbers of distinct voxels. Which voxels are
 * part of an instance is said by MapOptions::membership. */
struct Overlap
{
    instance_id_t instance = UNKNOWN_INSTANCE;
    uint32_t intersection = 0;    //!< voxels of both
    uint32_t opinionVoxels = 0;   //!< voxels of the opinion
    uint32_t instanceVoxels = 0;  //!< voxels of the instance
    uint32_t visibleVoxels = 0;   //!< voxels of the instance that the camera sees now
    uint32_t mappedVoxels = 0;    //!< voxels of the opinion where the map had evidence before, for
                                  //!< whatever instance
    double similarity = 0;        //!< S_sem, see semanticSimilarity()
    uint32_t touchedVoxels = 0;   //!< voxels of the opinion where the instance has any evidence,
                                  //!< even where it is outvoted and they are not part of it

    /** Intersection over union, in [0,1]. */
    [[nodiscard]] double iou() const
    {
        return static_cast<double>(intersection) /
               static_cast<double>(opinionVoxels + instanceVoxels - intersection);
    }
    /** Intersection over visible, in [0,1] (paper, "Data Association"): how much of what could be
     * seen of the instance the opinion covers. */
    [[nodiscard]] double iov() const
    {
        return static_cast<double>(intersection) /
               static_cast<double>(std::max({visibleVoxels, intersection, 1U}));
    }
    /** Intersection over mapped, in [0,1]: how much of what the map knew of the opinion's place
     * belongs to the instance. The mirror image of iov(): without it a table's mask would match the
     * cup that stands on the table, all of whose visible voxels it covers. */
    [[nodiscard]] double iom() const
    {
        return static_cast<double>(intersection) /
               static_cast<double>(std::max({mappedVoxels, intersection, 1U}));
    }
    /** Share of the opinion in which the instance was seen before, outvoted or not, in [0,1]. */
    [[nodiscard]] double touched() const
    {
        return static_cast<double>(touchedVoxels) / static_cast<double>(opinionVoxels);
    }
};

/** An opinion with all map instances that have evidence in its voxels, ordered by id; those of
 * which no voxel is part have an intersection of 0. */
struct OpinionOverlaps
{
    const Opinion* opinion = nullptr;
    CategoryEvidence categories;  //!< the opinion's distribution, in the map's category numbers
    std::vector<Overlap> candidates;
    std::vector<uint32_t> shared;  //!< voxels that it has in common with each opinion of the frame
};

/** Whether two opinions of a frame, by their numbers, share less than half of the smaller one. An
 * object is rarely detected in pieces, so they are most likely about two objects; masks that bleed
 * over each other's edge share voxels too, but fewer. */
inline bool lieApart(const std::vector<OpinionOverlaps>& opinions, size_t a, size_t b)
{
    const size_t smaller =
        std::min(opinions[a].opinion->voxels.size(), opinions[b].opinion->voxels.size());
    return 2 * static_cast<size_t>(opinions[a].shared[b]) < smaller;
}

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

/** Section [refinement]: when two map instances are one object (paper, "Multi-instance
 * Integration"). */
struct MergeThresholds
{
    double iou = 0.8;         //!< dominant geometric match: intersection over union above this
    bool use_ios = true;      //!< also merge by hybrid validation, that is:
    double ios = 0.7;         //!< least intersection over smaller, together with ...
    double similarity = 0.8;  //!< ... least semantic similarity
};
}  // namespace voxeland
