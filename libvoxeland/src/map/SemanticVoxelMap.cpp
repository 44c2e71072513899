// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/SemanticVoxelMap.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace voxeland
{
namespace
{
/** Adds an event, and forgets the oldest one of many. */
void remember(std::vector<InstanceEvent>& history, const InstanceEvent& event)
{
    constexpr size_t MOST = 64;
    history.push_back(event);
    if (history.size() > MOST) history.erase(history.begin());
}

/** What decisions about an instance say about a part of it. \param share in [0,1] */
std::vector<Decision> scaled(std::vector<Decision> decisions, double share)
{
    for (Decision& d : decisions) d.evidence *= share;
    const auto isNone = [](const Decision& d) { return !(d.evidence > 0); };
    decisions.erase(std::remove_if(decisions.begin(), decisions.end(), isNone), decisions.end());
    return decisions;
}

/** The nearest whole number to a share of some observations. \param share in [0,1] */
uint32_t shareOf(uint32_t observations, double share)
{
    return static_cast<uint32_t>(std::lround(share * observations));
}

/** Square of the distance to the nearest of some points [m^2]. */
float squaredDistance(const mrpt::math::TPoint3Df& from,
                      const std::vector<mrpt::math::TPoint3Df>& points)
{
    float least = std::numeric_limits<float>::infinity();
    for (const auto& p : points) least = std::min(least, (p - from).sqrNorm());
    return least;
}
}  // namespace

SemanticVoxelMap::SemanticVoxelMap(const MapOptions& options)
    : m_options(options), m_filter(options.occupancy)
{
    if (!(options.resolution > 0)) throw std::invalid_argument("map resolution must be positive");
    if (!(options.membership >= 0 && options.membership <= 1))
        throw std::invalid_argument("membership must be within 0 and 1");
    if (!(options.prior_strength >= 0))
        throw std::invalid_argument("prior_strength must not be negative");
}

void SemanticVoxelMap::setOptions(const MapOptions& options)
{
    const auto built = [](const MapOptions& o) {
        return std::tuple(o.resolution, o.membership, o.occupancy.prob_hit, o.occupancy.prob_miss,
                          o.occupancy.prob_min, o.occupancy.prob_max);
    };
    if (!empty() && built(options) != built(m_options))
        throw std::invalid_argument(
            "the map was built with another resolution, membership or occupancy model, which "
            "cannot be changed");
    SemanticVoxelMap check(options);
    m_options = options;
    m_filter = check.m_filter;
}

void SemanticVoxelMap::placeNear(const mrpt::math::TPoint3D& place)
{
    if (!empty()) return;
    const double blockSide = BLOCK_SIDE * m_options.resolution;
    const double near = (MAX_VOXEL_COORD + 1) / 2 * m_options.resolution;
    for (size_t a = 0; a < 3; ++a)
        m_origin[a] = std::abs(place[a]) < near ? 0 : std::round(place[a] / blockSide) * blockSide;
}

void SemanticVoxelMap::clear()
{
    Calibration calibration = std::move(m_calibration);
    *this = SemanticVoxelMap(m_options);
    m_calibration = std::move(calibration);
}

VoxelCoord SemanticVoxelMap::voxelOf(const mrpt::math::TPoint3D& p) const
{
    if (const auto v = storableVoxelOf(p, 1 / resolution())) return *v;
    const auto text = [](const mrpt::math::TPoint3D& q) {
        return "(" + numberText(q.x) + ", " + numberText(q.y) + ", " + numberText(q.z) + ")";
    };
    throw ConfigurationError(
        "the place " + text(inWorld(p)) + " is out of the map's range: with voxels of " +
        numberText(resolution()) + " m, coordinates are within +-" +
        fixedText(MAX_VOXEL_COORD * resolution(), 0) + " m of " + text(m_origin));
}

log_odds_t SemanticVoxelMap::occupancyAt(const mrpt::math::TPoint3D& p) const
{
    const auto v = storableVoxelOf(p, 1 / resolution());
    return v ? occupancy(*v) : UNOBSERVED;
}

log_odds_t SemanticVoxelMap::occupancy(const VoxelCoord& v) const
{
    const MapBlock* block = m_blocks.find(blockOf(v));
    return block == nullptr ? UNOBSERVED : block->occupancy(cellOf(v));
}

const VoxelEvidence* SemanticVoxelMap::evidence(const VoxelCoord& v) const
{
    const MapBlock* block = m_blocks.find(blockOf(v));
    return block == nullptr ? nullptr : block->evidence(cellOf(v));
}

template <typename Change>
void SemanticVoxelMap::changeEvidence(VoxelEvidence& evidence, Change&& change)
{
    forEachMember(evidence, [this](instance_id_t id) { --m_instances.at(id).voxels; });
    change(evidence);
    forEachMember(evidence, [this](instance_id_t id) { ++m_instances.at(id).voxels; });
}

void SemanticVoxelMap::addEvidence(const VoxelCoord& v, instance_id_t instance, float alpha)
{
    if (!(alpha > 0) || !std::isfinite(alpha)) return;
    const VoxelCoord block = blockOf(v);
    VoxelEvidence& evidence = m_blocks.at(block).evidenceAt(cellOf(v));
    if (instance == UNKNOWN_INSTANCE) {
        evidence.add(instance, alpha);
        return;
    }
    bool isNew = false;
    changeEvidence(evidence, [&](VoxelEvidence& e) { isNew = e.add(instance, alpha); });
    if (isNew) m_instances.at(instance).blocks.insert(block);
}

instance_id_t SemanticVoxelMap::resolve(instance_id_t id) const
{
    while (m_instances.count(id) == 0) {
        const auto at = m_absorbed.find(id);
        if (at == m_absorbed.end()) return UNKNOWN_INSTANCE;
        id = at->second;
    }
    return id;
}

Instance& SemanticVoxelMap::createInstance()
{
    if (m_nextInstance == std::numeric_limits<instance_id_t>::max())
        throw InputError("the map has no numbers left for instances: begin a new one");
    Instance& i = m_instances[m_nextInstance];
    i.id = m_nextInstance++;
    m_byLastFrame.emplace(i.lastFrame, i.id);
    return i;
}

void SemanticVoxelMap::saw(instance_id_t id, uint32_t frame)
{
    Instance& i = m_instances.at(id);
    if (frame == i.lastFrame) return;
    m_byLastFrame.erase({i.lastFrame, id});
    i.lastFrame = frame;
    m_byLastFrame.emplace(frame, id);
}

std::vector<instance_id_t> SemanticVoxelMap::seenSince(uint32_t frame) const
{
    std::vector<instance_id_t> ids;
    for (auto at = m_byLastFrame.lower_bound({frame, 0}); at != m_byLastFrame.end(); ++at)
        ids.push_back(at->second);
    std::sort(ids.begin(), ids.end());
    return ids;
}

void SemanticVoxelMap::moveEvidence(MapBlock& block, const VoxelCoord& blockCoord, int cell,
                                    instance_id_t from, instance_id_t to)
{
    VoxelEvidence* evidence = block.evidence(cell);
    if (evidence == nullptr || !(evidence->alphaOf(from) > 0)) return;
    changeEvidence(*evidence, [&](VoxelEvidence& e) { e.add(to, e.remove(from)); });
    m_instances.at(to).blocks.insert(blockCoord);
}

void SemanticVoxelMap::merge(instance_id_t survivor, instance_id_t absorbed, uint32_t frame)
{
    if (survivor == absorbed) throw std::invalid_argument("an instance cannot absorb itself");
    Instance& to = m_instances.at(survivor);
    Instance& from = m_instances.at(absorbed);
    for (const VoxelCoord& b : from.blocks) {
        MapBlock& block = *m_blocks.find(b);
        block.surface().forEach(
            [&](int cell) { moveEvidence(block, b, cell, absorbed, survivor); });
    }
    to.categories.add(from.categories);
    to.observations += from.observations;
    to.firstFrame = std::min(to.firstFrame, from.firstFrame);
    saw(survivor, std::max(to.lastFrame, from.lastFrame));
    to.tracks.insert(from.tracks.begin(), from.tracks.end());
    to.views.add(from.views, m_options.views_kept);
    to.decisions.insert(to.decisions.end(), from.decisions.begin(), from.decisions.end());
    for (const InstanceEvent& event : from.history) remember(to.history, event);
    std::stable_sort(to.history.begin(), to.history.end(),
                     [](const auto& a, const auto& b) { return a.frame < b.frame; });
    remember(to.history, {InstanceEvent::Kind::merged, frame, survivor, absorbed});
    m_byLastFrame.erase({from.lastFrame, absorbed});
    m_instances.erase(absorbed);
    m_inactive.erase(absorbed);
    m_absorbed[absorbed] = survivor;
}

Instance& SemanticVoxelMap::split(instance_id_t from, const std::vector<VoxelCoord>& voxels,
                                  double categoryShare, uint32_t frame)
{
    Instance& part = createInstance();
    Instance& whole = m_instances.at(from);
    for (const VoxelCoord& v : voxels) {
        const VoxelCoord block = blockOf(v);
        moveEvidence(*m_blocks.find(block), block, cellOf(v), from, part.id);
    }
    part.categories = whole.categories.take(categoryShare);
    part.observations = shareOf(whole.observations, categoryShare);
    whole.observations -= part.observations;
    part.firstFrame = whole.firstFrame;
    saw(part.id, whole.lastFrame);
    part.decisions = scaled(whole.decisions, categoryShare);
    whole.decisions = scaled(whole.decisions, 1 - categoryShare);
    const auto ofPart = centersOf(part), ofWhole = centersOf(whole);
    whole.views.moveTo(
        part.views,
        [&](const InstanceView& v) {
            return squaredDistance(v.target, ofPart) < squaredDistance(v.target, ofWhole);
        },
        m_options.views_kept);
    remember(whole.history, {InstanceEvent::Kind::divided, frame, from, part.id});
    part.history = whole.history;
    return part;
}

std::vector<mrpt::math::TPoint3Df> SemanticVoxelMap::centersOf(const Instance& instance) const
{
    std::vector<mrpt::math::TPoint3Df> centers;
    for (const VoxelCoord& b : instance.blocks)
        m_blocks.find(b)->forEachSurface([&](int cell, const VoxelEvidence& evidence) {
            if (evidence.alphaOf(instance.id) > 0)
                centers.push_back(
                    voxelCenter<mrpt::math::TPoint3Df>(voxelAt(b, cell), m_options.resolution));
        });
    return centers;
}

CategoryEvidence SemanticVoxelMap::categoryEvidence(const Instance& instance) const
{
    return instance.withDecisions(
        m_calibration.applied(instance.categories.independent(), m_categories));
}

void SemanticVoxelMap::deactivate(instance_id_t id)
{
    m_inactive.insert(m_instances.at(id).id);
}

instance_id_t SemanticVoxelMap::winnerOfTheRest(const VoxelEvidence& evidence) const
{
    VoxelEvidence rest = evidence;
    for (const auto& e : evidence)
        if (isInactive(e.instance)) rest.remove(e.instance);
    return rest.strongest();
}

double SemanticVoxelMap::Memory::bytesPerFreeVoxel() const
{
    return observedVoxels == 0
               ? 0
               : static_cast<double>(bytes - evidenceBytes) / static_cast<double>(observedVoxels);
}

double SemanticVoxelMap::Memory::bytesPerSurfaceVoxel() const
{
    return surfaceVoxels == 0 ? 0
                              : bytesPerFreeVoxel() + static_cast<double>(evidenceBytes) /
                                                          static_cast<double>(surfaceVoxels);
}

SemanticVoxelMap::Memory SemanticVoxelMap::memory() const
{
    Memory m;
    for (size_t b = 0; b < m_blocks.size(); ++b) {
        m.evidenceBytes += m_blocks[b].heapMemory();
        m.observedVoxels += static_cast<size_t>(m_blocks[b].observedCells());
        m.surfaceVoxels += static_cast<size_t>(m_blocks[b].surface().count());
    }
    m.bytes = m_blocks.memory() + m.evidenceBytes;
    return m;
}
}  // namespace voxeland
