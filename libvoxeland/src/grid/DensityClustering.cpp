// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/grid/DensityClustering.h"

#include "voxeland/grid/CoordHash.h"

#include <algorithm>

namespace voxeland
{
namespace
{
constexpr int NOISE = -1;

/** Finds the cells around a cell. */
class Neighbourhood
{
 public:
    Neighbourhood(const std::vector<WeightedCell>& cells, int radius)
        : m_cells(cells), m_radius(radius)
    {
        m_index.reserve(cells.size());
        for (uint32_t i = 0; i < cells.size(); ++i) m_index.insert(cells[i].coord, i);
    }

    /** Numbers of the cells around cell i, itself included. */
    const std::vector<uint32_t>& of(uint32_t i)
    {
        m_found.clear();
        const VoxelCoord c = m_cells[i].coord;
        for (int dz = -m_radius; dz <= m_radius; ++dz)
            for (int dy = -m_radius; dy <= m_radius; ++dy)
                for (int dx = -m_radius; dx <= m_radius; ++dx) {
                    const uint32_t n = m_index.find(c + VoxelCoord{dx, dy, dz});
                    if (n != CoordHash::NONE) m_found.push_back(n);
                }
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
    const std::vector<WeightedCell>& m_cells;
    int m_radius;
    CoordHash m_index;
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
        if (expanded[seed] || cluster[seed] != NOISE) continue;
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
