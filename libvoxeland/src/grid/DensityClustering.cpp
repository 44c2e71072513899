// SPDX-License-Identifier: BSD-3-Clause
#include "DensityClustering.h"

#include "voxeland/grid/BlockMap.h"

#include <algorithm>
#include <array>

namespace voxeland
{
namespace
{
/** The numbers of a block's cells, from 1; 0: there is no such cell. */
struct NumberedBlock
{
    std::array<uint32_t, BLOCK_CELLS> numbers{};
};

/** Finds the cells around a cell. */
class Neighbourhood
{
 public:
    Neighbourhood(const std::vector<WeightedCell>& cells, int radius)
        : m_cells(cells), m_radius(radius)
    {
        for (uint32_t i = 0; i < cells.size(); ++i) {
            const VoxelCoord& c = cells[i].coord;
            m_blocks.at(blockOf(c)).numbers[static_cast<size_t>(cellOf(c))] = i + 1;
        }
    }

    /** Numbers of the cells around cell i, itself included. */
    const std::vector<uint32_t>& of(uint32_t i)
    {
        m_found.clear();
        const VoxelCoord low = m_cells[i].coord + VoxelCoord{-m_radius, -m_radius, -m_radius};
        const VoxelCoord high = m_cells[i].coord + VoxelCoord{m_radius, m_radius, m_radius};
        const VoxelCoord first = blockOf(low), last = blockOf(high);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                    if (const NumberedBlock* block = m_blocks.find({x, y, z}))
                        collect(*block, voxelAt({x, y, z}, 0), low, high);
        return m_found;
    }

    /** Whether the cell is a core, given what of() said about it. */
    [[nodiscard]] bool isCore(uint32_t i, const std::vector<uint32_t>& around) const
    {
        float weight = 0;
        for (const uint32_t n : around) weight += m_cells[n].weight;
        return weight >= m_cells[i].coreWeight;
    }

 private:
    /** Adds a block's cells from `low` to `high`. \param corner the block's first cell */
    void collect(const NumberedBlock& block, const VoxelCoord& corner, const VoxelCoord& low,
                 const VoxelCoord& high)
    {
        constexpr int END = BLOCK_SIDE - 1;
        const int firstX = std::max(low.x - corner.x, 0), lastX = std::min(high.x - corner.x, END);
        const int firstY = std::max(low.y - corner.y, 0), lastY = std::min(high.y - corner.y, END);
        const int firstZ = std::max(low.z - corner.z, 0), lastZ = std::min(high.z - corner.z, END);
        for (int z = firstZ; z <= lastZ; ++z)
            for (int y = firstY; y <= lastY; ++y)
                for (int x = firstX; x <= lastX; ++x) {
                    const uint32_t number = block.numbers[static_cast<size_t>(cellOf({x, y, z}))];
                    if (number != 0) m_found.push_back(number - 1);
                }
    }

    const std::vector<WeightedCell>& m_cells;
    int m_radius;
    BlockMap<NumberedBlock> m_blocks;
    std::vector<uint32_t> m_found;
};
}  // namespace

std::vector<int> clusterByDensity(const std::vector<WeightedCell>& cells, int radius)
{
    std::vector<int> cluster(cells.size(), NOISE);
    std::vector<bool> expanded(cells.size(), false);
    Neighbourhood neighbourhood(cells, radius);
    std::vector<uint32_t> open;
    int clusters = 0;
    for (uint32_t seed = 0; seed < cells.size(); ++seed) {
        if (expanded[seed]) continue;  // so is every cell of a cluster
        open.assign(1, seed);
        bool started = false;
        while (!open.empty()) {
            const uint32_t i = open.back();
            open.pop_back();
            if (expanded[i]) continue;
            expanded[i] = true;
            const auto& around = neighbourhood.of(i);
            if (!neighbourhood.isCore(i, around)) continue;
            started = true;
            for (const uint32_t n : around) {
                if (cluster[n] != NOISE) continue;
                cluster[n] = clusters;
                if (!expanded[n]) open.push_back(n);
            }
        }
        if (started) ++clusters;
    }
    return cluster;
}

int heaviestCluster(const std::vector<WeightedCell>& cells, const std::vector<int>& clusters)
{
    std::vector<double> weight;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (clusters[i] == NOISE) continue;
        weight.resize(std::max(weight.size(), static_cast<size_t>(clusters[i]) + 1), 0.0);
        weight[static_cast<size_t>(clusters[i])] += static_cast<double>(cells[i].weight);
    }
    if (weight.empty()) return NOISE;
    return static_cast<int>(std::max_element(weight.begin(), weight.end()) - weight.begin());
}
}  // namespace voxeland
