// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/Overlaps.h"

#include "voxeland/map/SemanticVoxelMap.h"

#include <algorithm>
#include <bitset>

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

/** The voxels of an opinion as bits, by the words that have any. */
class HitSet
{
 public:
    explicit HitSet(const std::vector<OpinionVoxel>& voxels)
    {
        std::vector<uint32_t> hits;
        for (const OpinionVoxel& v : voxels) hits.push_back(v.hit);
        std::sort(hits.begin(), hits.end());
        for (const uint32_t hit : hits) {
            if (m_words.empty() || m_words.back().first != hit / BITS)
                m_words.emplace_back(hit / BITS, 0);
            m_words.back().second |= uint64_t{1} << (hit % BITS);
        }
    }
    [[nodiscard]] uint32_t inCommonWith(const HitSet& other) const
    {
        uint32_t count = 0;
        auto a = m_words.begin(), b = other.m_words.begin();
        while (a != m_words.end() && b != other.m_words.end()) {
            const uint32_t wordA = a->first, wordB = b->first;
            if (wordA == wordB)
                count += static_cast<uint32_t>(std::bitset<BITS>(a->second & b->second).count());
            a += wordA <= wordB ? 1 : 0;
            b += wordB <= wordA ? 1 : 0;
        }
        return count;
    }

 private:
    static constexpr uint32_t BITS = 64;
    std::vector<std::pair<uint32_t, uint64_t>> m_words;
};

/** Fills OpinionOverlaps::shared. Cost: each pair of opinions, and a 64th of its voxels. */
void countShared(std::vector<OpinionOverlaps>& opinions)
{
    std::vector<HitSet> hits;
    for (OpinionOverlaps& o : opinions) {
        hits.emplace_back(o.opinion->voxels);
        o.shared.assign(opinions.size(), 0);
    }
    for (size_t i = 0; i < opinions.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            opinions[i].shared[j] = opinions[j].shared[i] = hits[i].inCommonWith(hits[j]);
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
            o.similarity = semanticSimilarity(asEvidence, instance.categories.sum());
            overlaps.candidates.push_back(o);
        }
        result.push_back(std::move(overlaps));
    }
    countShared(result);
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
