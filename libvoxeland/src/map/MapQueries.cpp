// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/MapQueries.h"

#include <algorithm>
#include <limits>

namespace voxeland
{
namespace
{
/** beta_l plus the prior W/K, indexed by category id; *unknown* is the last, and has no prior. */
std::vector<double> concentration(const SemanticVoxelMap& map, const Instance& instance)
{
    const size_t known = map.categories().size();
    const double prior = known == 0 ? 0 : map.options().prior_strength / static_cast<double>(known);
    std::vector<double> beta(known, prior);
    beta.push_back(0);
    const CategoryEvidence evidence = map.categoryEvidence(instance);
    for (const auto& e : evidence.entries()) beta[std::min<size_t>(e.category, known)] += e.beta;
    return beta;
}

/** Whether evidence for an instance counts as evidence for *unknown*. */
bool isShownAsUnknown(const SemanticVoxelMap& map, instance_id_t instance)
{
    return instance == UNKNOWN_INSTANCE || map.isInactive(instance);
}

/** Grows a summary by one voxel. */
void extend(InstanceSummary& s, const mrpt::math::TPoint3D& center, double halfEdge, double entropy)
{
    for (size_t a = 0; a < 3; ++a) {
        s.centroid[a] += center[a];
        s.boxMin[a] = std::min(s.boxMin[a], center[a] - halfEdge);
        s.boxMax[a] = std::max(s.boxMax[a], center[a] + halfEdge);
    }
    s.geometricEntropy += entropy;
    ++s.voxels;
}
}  // namespace

std::vector<RankedCategory> categoryDistribution(const SemanticVoxelMap& map,
                                                 const Instance& instance)
{
    const std::vector<double> beta = concentration(map, instance);
    double total = 0;
    for (const double b : beta) total += b;
    std::vector<RankedCategory> ranked;
    for (size_t i = 0; i < beta.size(); ++i) {
        const bool known = i < map.categories().size();
        const category_id_t c = known ? static_cast<category_id_t>(i) : UNKNOWN_CATEGORY_ID;
        if (beta[i] > 0) ranked.push_back({c, map.categories().name(c), beta[i] / total});
    }
    std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
        return a.probability != b.probability ? a.probability > b.probability : a.name < b.name;
    });
    return ranked;
}

double categoryEntropy(const SemanticVoxelMap& map, const Instance& instance)
{
    return dirichletEntropy(concentration(map, instance), map.options().entropy);
}

double categoryVacuity(const SemanticVoxelMap& map, const Instance& instance)
{
    const double prior = map.options().prior_strength;
    return prior > 0 ? vacuity(prior, map.categoryEvidence(instance).total()) : 0;
}

double winnerProbability(const SemanticVoxelMap& map, const VoxelEvidence& evidence)
{
    const instance_id_t winner = map.winner(evidence);
    double forWinner = 0, total = 0;
    for (const auto& e : evidence) {
        const bool isUnknown = isShownAsUnknown(map, e.instance);
        if ((isUnknown ? UNKNOWN_INSTANCE : e.instance) == winner)
            forWinner += static_cast<double>(e.alpha);
        total += static_cast<double>(e.alpha);
    }
    return total > 0 ? forWinner / total : 0;
}

double instanceEntropy(const SemanticVoxelMap& map, const VoxelEvidence& evidence)
{
    std::vector<double> alpha(1, 0.0);  // that of *unknown* first
    for (const auto& e : evidence) {
        const auto a = static_cast<double>(e.alpha);
        if (isShownAsUnknown(map, e.instance))
            alpha.front() += a;
        else
            alpha.push_back(a);
    }
    if (alpha.front() == 0) alpha.erase(alpha.begin());
    return dirichletEntropy(alpha, map.options().entropy);
}

std::vector<InstanceSummary> summarizeInstances(const SemanticVoxelMap& map)
{
    constexpr double INF = std::numeric_limits<double>::infinity();
    std::map<instance_id_t, InstanceSummary> byId;
    const double half = map.resolution() / 2;
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const instance_id_t id = map.winner(evidence);
        if (id == UNKNOWN_INSTANCE) return;
        const auto [at, isNew] = byId.try_emplace(id);
        if (isNew) {
            at->second.boxMin = {INF, INF, INF};
            at->second.boxMax = {-INF, -INF, -INF};
        }
        extend(at->second, voxelCenter<mrpt::math::TPoint3D>(v, map.resolution()), half,
               instanceEntropy(map, evidence));
    });
    std::vector<InstanceSummary> summaries;
    for (auto& [id, s] : byId) {
        const Instance& instance = map.instance(id);
        s.id = id;
        s.categories = categoryDistribution(map, instance);
        s.entropy = categoryEntropy(map, instance);
        s.vacuity = categoryVacuity(map, instance);
        s.observations = instance.observations;
        s.geometricEntropy /= s.voxels;
        s.centroid = map.inWorld(s.centroid * (1.0 / s.voxels));
        s.boxMin = map.inWorld(s.boxMin);
        s.boxMax = map.inWorld(s.boxMax);
        summaries.push_back(std::move(s));
    }
    return summaries;
}

std::map<instance_id_t, std::vector<VoxelCoord>> voxelsByWinner(const SemanticVoxelMap& map,
                                                                bool occupiedOnly)
{
    std::map<instance_id_t, std::vector<VoxelCoord>> voxels;
    map.forEachVoxel(
        [&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
            voxels[map.winner(evidence)].push_back(v);
        },
        occupiedOnly);
    return voxels;
}

VoxelUncertainty::VoxelUncertainty(const SemanticVoxelMap& map) : m_map(map)
{
    for (const auto& [id, instance] : map.instances()) {
        if (map.isInactive(id)) continue;
        m_distributions[id] = categoryDistribution(map, instance);
        m_entropies[id] = voxeland::categoryEntropy(map, instance);
    }
}

const std::vector<double>& VoxelUncertainty::categories(const VoxelEvidence& evidence)
{
    m_categories.assign(m_map.categories().size() + 1, 0.0);
    const double total = static_cast<double>(evidence.total());
    for (const auto& e : evidence) {
        const double pInstance = static_cast<double>(e.alpha) / total;
        const auto at = m_distributions.find(e.instance);
        if (at == m_distributions.end() || at->second.empty())
            m_categories.back() += pInstance;
        else
            for (const auto& c : at->second)
                m_categories[std::min<size_t>(c.category, m_map.categories().size())] +=
                    c.probability * pInstance;
    }
    return m_categories;
}

double VoxelUncertainty::categoryEntropy(const VoxelEvidence& evidence)
{
    return shannonEntropy(categories(evidence));
}

double VoxelUncertainty::instanceEntropy(const VoxelEvidence& evidence) const
{
    return voxeland::instanceEntropy(m_map, evidence);
}

double VoxelUncertainty::winnerCategoryEntropy(const VoxelEvidence& evidence) const
{
    const auto at = m_entropies.find(m_map.winner(evidence));
    return at == m_entropies.end() ? 0 : at->second;
}
}  // namespace voxeland
