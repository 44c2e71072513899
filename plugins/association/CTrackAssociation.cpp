// SPDX-License-Identifier: BSD-3-Clause
#include "CTrackAssociation.h"

#include "voxeland/base/RegisteredClass.h"

#include <algorithm>
#include <map>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CTrackAssociation, voxeland::CAssociationPolicy, voxeland)

namespace
{
/** Instances by track; UNKNOWN_INSTANCE for tracks without one. */
using InstancesOfTracks = std::map<int64_t, instance_id_t>;

bool isTracked(const OpinionOverlaps& o)
{
    return o.opinion->track != InstancePrediction::NO_TRACK;
}

/** Looks for each opinion's track among the instances that the opinion overlaps. */
InstancesOfTracks findAmongCandidates(const std::vector<OpinionOverlaps>& opinions,
                                      const SemanticVoxelMap& map)
{
    InstancesOfTracks found;
    for (const OpinionOverlaps& o : opinions) {
        if (!isTracked(o)) continue;
        instance_id_t& instance =
            found.try_emplace(o.opinion->track, UNKNOWN_INSTANCE).first->second;
        for (const Overlap& candidate : o.candidates)
            if (map.instance(candidate.instance).tracks.count(o.opinion->track) > 0)
                instance = candidate.instance;
    }
    return found;
}

/** Looks in the whole map for the tracks that still have no instance. */
void findInMap(InstancesOfTracks& wanted, const SemanticVoxelMap& map)
{
    for (const auto& [id, instance] : map.instances())
        for (const int64_t track : instance.tracks)
            if (const auto at = wanted.find(track);
                at != wanted.end() && at->second == UNKNOWN_INSTANCE)
                at->second = id;
}
}  // namespace

std::string CTrackAssociation::description() const
{
    return "the detector's track ids, from a tracker or ground truth";
}

std::vector<Assignment> CTrackAssociation::associate(const std::vector<OpinionOverlaps>& opinions,
                                                     const SemanticVoxelMap& map) const
{
    InstancesOfTracks instanceOf = findAmongCandidates(opinions, map);
    const bool complete = std::all_of(instanceOf.begin(), instanceOf.end(), [](const auto& entry) {
        return entry.second != UNKNOWN_INSTANCE;
    });
    if (!complete) findInMap(instanceOf, map);

    std::vector<Assignment> assignments;
    std::map<int64_t, uint32_t> newInstanceOf;
    for (const OpinionOverlaps& o : opinions) {
        Assignment assignment;
        assignment.newInstance = static_cast<uint32_t>(assignments.size());
        if (isTracked(o)) {
            const int64_t track = o.opinion->track;
            assignment.instance = instanceOf.at(track);
            assignment.newInstance =
                newInstanceOf.try_emplace(track, assignment.newInstance).first->second;
        }
        assignments.push_back(assignment);
    }
    return assignments;
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CTrackAssociation> REGISTERED;
