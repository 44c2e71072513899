// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/Overlaps.h"

#include "voxeland/map/SemanticVoxelMap.h"

#include <algorithm>
#include <limits>

namespace voxeland
{
namespace
{
CategoryEvidence numbered(const CategoryDistribution& distribution, CategoryTable& table)
{
    CategoryEvidence evidence;
    for (const auto& c : distribution)
        evidence.add(table.add(c.name), static_cast<double>(c.probability));
    return evidence;
}

/** Fills OpinionOverlaps::shared. Cost: the opinions' voxels, and those they share. */
void countShared(std::vector<OpinionOverlaps>& opinions, size_t hits)
{
    struct Claim
    {
        size_t opinion;
        size_t earlier;  // number of the previous claim of the same voxel
    };
    constexpr size_t NONE = std::numeric_limits<size_t>::max();
    std::vector<Claim> claims;
    std::vector<size_t> latest(hits, NONE);
    for (OpinionOverlaps& o : opinions) o.shared.assign(opinions.size(), 0);
    for (size_t i = 0; i < opinions.size(); ++i)
        for (const OpinionVoxel& v : opinions[i].opinion->voxels) {
            for (size_t c = latest[v.hit]; c != NONE; c = claims[c].earlier) {
                ++opinions[i].shared[claims[c].opinion];
                ++opinions[claims[c].opinion].shared[i];
            }
            claims.push_back({i, latest[v.hit]});
            latest[v.hit] = claims.size() - 1;
        }
}
}  // namespace

void OverlapFinder::countVisible(const ObservedSpace& space, const SemanticVoxelMap& map)
{
    m_visible.clear();
    for (size_t b = 0; b < space.size(); ++b) {
        const MapBlock* block = map.blocks().find(space.coordOf(b));
        if (block == nullptr || !block->surface().any()) continue;
        const CellMask seen = space[b].visible() & block->surface();
        seen.forEach([&](int cell) {
            map.forEachMember(*block->evidence(cell),
                              [this](instance_id_t id) { m_visible.add(id); });
        });
    }
}

std::vector<OpinionOverlaps> OverlapFinder::find(const PreparedFrame& frame, double sharpness,
                                                 SemanticVoxelMap& map)
{
    std::vector<OpinionOverlaps> result;
    countVisible(frame.space, map);
    for (const Opinion& opinion : frame.opinions) {
        OpinionOverlaps overlaps;
        overlaps.opinion = &opinion;
        overlaps.categories = numbered(opinion.categories, map.categories());
        const CategoryEvidence asEvidence = sharpened(overlaps.categories, sharpness);
        m_common.clear();
        m_touched.clear();
        uint32_t mapped = 0;
        for (const OpinionVoxel& v : opinion.voxels)
            if (const VoxelEvidence* evidence = map.evidence(frame.voxels.hits()[v.hit].coord)) {
                ++mapped;
                map.forEachMember(*evidence, [this](instance_id_t id) { m_common.add(id); });
                for (const auto& e : *evidence)
                    if (e.instance != UNKNOWN_INSTANCE) m_touched.add(e.instance);
            }
        for (const instance_id_t id : m_touched.counted()) {
            const Instance& instance = map.instance(id);
            Overlap o;
            o.instance = id;
            o.intersection = m_common.of(id);
            o.opinionVoxels = static_cast<uint32_t>(opinion.voxels.size());
            o.instanceVoxels = instance.voxels;
            o.visibleVoxels = m_visible.of(id);
            o.mappedVoxels = mapped;
            o.touchedVoxels = m_touched.of(id);
            o.similarity = semanticSimilarity(asEvidence, instance.evidence());
            overlaps.candidates.push_back(o);
        }
        result.push_back(std::move(overlaps));
    }
    countShared(result, frame.voxels.hits().size());
    return result;
}

std::vector<instance_id_t> OverlapFinder::missed(const std::vector<instance_id_t>& claimed,
                                                 double share, const SemanticVoxelMap& map)
{
    std::vector<instance_id_t> missed;
    for (const instance_id_t id : m_visible.counted()) {
        const bool isClaimed = std::find(claimed.begin(), claimed.end(), id) != claimed.end();
        if (!isClaimed && m_visible.of(id) > share * map.instance(id).voxels) missed.push_back(id);
    }
    return missed;
}
}  // namespace voxeland
