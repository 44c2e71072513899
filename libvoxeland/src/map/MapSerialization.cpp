// SPDX-License-Identifier: BSD-3-Clause
#include "InstanceSerialization.h"
#include "base/Reading.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/stl_serialization.h>

#include <array>
#include <cmath>
#include <stdexcept>

using mrpt::serialization::CArchive;

namespace voxeland
{
namespace
{
constexpr uint8_t VERSION = 4;

void write(CArchive& out, const MapOptions& o)
{
    out << o.resolution << o.membership << o.occupancy.prob_hit << o.occupancy.prob_miss
        << o.occupancy.prob_min << o.occupancy.prob_max << o.prior_strength << toString(o.entropy)
        << o.views_kept;
}

MapOptions readOptions(CArchive& in, uint8_t version)
{
    MapOptions o;
    in >> o.resolution >> o.membership >> o.occupancy.prob_hit >> o.occupancy.prob_miss >>
        o.occupancy.prob_min >> o.occupancy.prob_max >> o.prior_strength;
    const std::string entropy = readText(in);
    in >> o.views_kept;
    if (version < 2) in.ReadAs<uint32_t>();  // categories that kept views
    o.entropy = entropyMeasureFromString(entropy);
    return o;
}

mrpt::math::TPoint3D readOrigin(CArchive& in)
{
    mrpt::math::TPoint3D origin;
    in >> origin.x >> origin.y >> origin.z;
    if (!std::isfinite(origin.sqrNorm())) throw std::runtime_error("corrupt map: no origin");
    return origin;
}

void write(CArchive& out, const Calibration& c)
{
    out << c.agreement() << static_cast<uint32_t>(c.meanings().size());
    for (const auto& [word, meaning] : c.meanings()) {
        out << word << static_cast<uint32_t>(meaning.size());
        for (const auto& [category, probability] : meaning) out << category << probability;
    }
}

Calibration readCalibration(CArchive& in)
{
    const auto agreement = in.ReadAs<double>();
    std::map<std::string, Calibration::Meaning> meanings;
    for (auto words = in.ReadAs<uint32_t>(); words > 0; --words) {
        Calibration::Meaning& meaning = meanings[readText(in)];
        for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
            const std::string category = readText(in);
            meaning[category] = in.ReadAs<double>();
        }
    }
    try {
        return Calibration(std::move(meanings), agreement);
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(std::string("corrupt map: ") + e.what());
    }
}

// One call for a block's occupancies: sets of maps are copied by writing and reading them.
void writeOccupancy(CArchive& out, const MapBlock& block)
{
    std::array<log_odds_t, BLOCK_CELLS> values;
    for (int cell = 0; cell < BLOCK_CELLS; ++cell)
        values[static_cast<size_t>(cell)] = block.occupancy(cell);
    out.WriteBufferFixEndianness(values.data(), values.size());
}

void readOccupancy(CArchive& in, MapBlock& block)
{
    std::array<log_odds_t, BLOCK_CELLS> values;
    if (in.ReadBufferFixEndianness(values.data(), values.size()) != sizeof(values))
        throw std::runtime_error("corrupt map: it ends within a block");
    for (int cell = 0; cell < BLOCK_CELLS; ++cell)
        block.setOccupancy(cell, values[static_cast<size_t>(cell)]);
}

void write(CArchive& out, const VoxelCoord& coord, const MapBlock& block)
{
    write(out, coord);
    writeOccupancy(out, block);
    out << static_cast<uint32_t>(block.surface().count());
    block.forEachSurface([&](int cell, const VoxelEvidence& evidence) {
        out << static_cast<uint16_t>(cell) << evidence.size();
        for (const auto& e : evidence) out << e.instance << e.alpha;
    });
}

/** Every absorbed instance must lead, by the survivors of its survivor, to one that was not. */
void checkMerges(const std::map<instance_id_t, instance_id_t>& absorbed, instance_id_t next)
{
    std::set<instance_id_t> ending;
    for (const auto& [first, survivor] : absorbed) {
        std::set<instance_id_t> chain;
        instance_id_t id = first;
        for (auto at = absorbed.find(id); at != absorbed.end() && ending.count(id) == 0;
             at = absorbed.find(id))
        {
            const bool isPossible = id != UNKNOWN_INSTANCE && id < next && chain.insert(id).second;
            if (!isPossible) throw std::runtime_error("corrupt map: an impossible merge");
            id = at->second;
        }
        if (id == UNKNOWN_INSTANCE || id >= next)
            throw std::runtime_error("corrupt map: a merge with an instance it lacks");
        ending.insert(chain.begin(), chain.end());
    }
}
}  // namespace

void SemanticVoxelMap::writeTo(CArchive& out) const
{
    out << VERSION;
    write(out, m_options);
    out << m_origin.x << m_origin.y << m_origin.z;
    write(out, m_calibration);
    out << m_categories.names() << m_nextInstance << m_absorbed << inactive();
    out << static_cast<uint32_t>(m_instances.size());
    for (const auto& [id, instance] : m_instances) write(out, instance);
    out << static_cast<uint32_t>(m_blocks.size());
    for (const uint32_t b : m_blocks.sorted()) write(out, m_blocks.coordOf(b), m_blocks[b]);
}

void SemanticVoxelMap::readFrom(CArchive& in)
{
    const auto version = in.ReadAs<uint8_t>();
    if (version < 1 || version > VERSION)
        throw std::runtime_error("map format version " + std::to_string(version) +
                                 " is not known: it was written by another Voxeland");
    SemanticVoxelMap read(readOptions(in, version));
    if (version > 2) read.m_origin = readOrigin(in);
    if (version > 3) read.m_calibration = readCalibration(in);
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) read.m_categories.add(readText(in));
    std::set<instance_id_t> inactive;
    in >> read.m_nextInstance >> read.m_absorbed >> inactive;
    checkMerges(read.m_absorbed, read.m_nextInstance);
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        Instance i = readInstance(in, read.m_categories, read.m_options.views_kept, version);
        const instance_id_t id = i.id;
        if (id == UNKNOWN_INSTANCE || id >= read.m_nextInstance || read.m_absorbed.count(id) > 0 ||
            !read.m_instances.emplace(id, std::move(i)).second)
            throw std::runtime_error("corrupt map: an instance numbered " + std::to_string(id));
    }
    for (const instance_id_t id : inactive) {
        if (read.m_instances.count(id) == 0)
            throw std::runtime_error("corrupt map: an inactive instance that it lacks");
        read.m_inactive.insert(id);
    }
    for (const auto& [id, instance] : read.m_instances)
        read.m_byLastFrame.emplace(instance.lastFrame, id);
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        const VoxelCoord coord = readBlockCoord(in);
        MapBlock& block = read.m_blocks.at(coord);
        readOccupancy(in, block);
        std::set<instance_id_t> present;
        for (auto surface = in.ReadAs<uint32_t>(); surface > 0; --surface) {
            const auto cell = in.ReadAs<uint16_t>();
            if (cell >= BLOCK_CELLS || block.surface().test(cell))
                throw std::runtime_error("corrupt map: no such voxel in a block, or twice");
            VoxelEvidence& evidence = block.evidenceAt(cell);
            for (auto entries = in.ReadAs<uint32_t>(); entries > 0; --entries) {
                const auto instance = in.ReadAs<instance_id_t>();
                if (instance != UNKNOWN_INSTANCE && read.m_instances.count(instance) == 0)
                    throw std::runtime_error("corrupt map: evidence for an instance it lacks");
                evidence.add(instance, readEvidence<float>(in));
                present.insert(instance);
            }
            read.forEachMember(evidence,
                               [&](instance_id_t id) { ++read.m_instances.at(id).voxels; });
        }
        present.erase(UNKNOWN_INSTANCE);
        for (const instance_id_t id : present) read.m_instances.at(id).blocks.insert(coord);
    }
    for (const auto& [id, instance] : read.m_instances)
        for (const VoxelCoord& b : instance.blocks)
            if (read.m_blocks.find(b) == nullptr)
                throw std::runtime_error("corrupt map: an instance in a block it lacks");
    *this = std::move(read);
}
}  // namespace voxeland
