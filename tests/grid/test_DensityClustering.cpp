// SPDX-License-Identifier: BSD-3-Clause
#include "grid/DensityClustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <queue>
#include <random>
#include <set>

using namespace voxeland;

namespace
{
bool areNeighbours(const VoxelCoord& a, const VoxelCoord& b, int radius)
{
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) <= radius;
}

/** What defines a DBSCAN clustering whatever the order: the cores, which of them belong together,
 *  and for every other cell the clusters that may claim it. */
struct Textbook
{
    std::vector<bool> core;
    std::vector<int> component;         //!< of cores; -1 elsewhere
    std::vector<std::set<int>> claims;  //!< components with a core next to the cell

    Textbook(const std::vector<WeightedCell>& cells, int radius)
        : core(cells.size()), component(cells.size(), -1), claims(cells.size())
    {
        const size_t n = cells.size();
        const auto near = [&](size_t i, size_t j) {
            return areNeighbours(cells[i].coord, cells[j].coord, radius);
        };
        for (size_t i = 0; i < n; ++i) {
            float weight = 0;
            for (size_t j = 0; j < n; ++j) weight += near(i, j) ? cells[j].weight : 0;
            core[i] = weight >= cells[i].coreWeight;
        }
        int components = 0;
        for (size_t i = 0; i < n; ++i) {
            if (!core[i] || component[i] >= 0) continue;
            std::queue<size_t> open;
            open.push(i);
            component[i] = components;
            for (; !open.empty(); open.pop())
                for (size_t j = 0; j < n; ++j) {
                    if (!core[j] || component[j] >= 0 || !near(open.front(), j)) continue;
                    component[j] = components;
                    open.push(j);
                }
            ++components;
        }
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j < n; ++j)
                if (core[j] && near(i, j)) claims[i].insert(component[j]);
    }
};

void expectClustering(const std::vector<WeightedCell>& cells, int radius)
{
    const Textbook expected(cells, radius);
    const std::vector<int> found = clusterByDensity(cells, radius);
    ASSERT_EQ(found.size(), cells.size());
    std::map<int, int> clusterOf;  // component -> cluster
    for (size_t i = 0; i < cells.size(); ++i)
        if (expected.core[i]) {
            ASSERT_GE(found[i], 0) << "core " << i;
            const auto at = clusterOf.emplace(expected.component[i], found[i]).first;
            ASSERT_EQ(at->second, found[i]) << "core " << i;
        }
    std::set<int> distinct;
    for (const auto& [component, cluster] : clusterOf) distinct.insert(cluster);
    EXPECT_EQ(distinct.size(), clusterOf.size()) << "components were joined";
    for (size_t i = 0; i < cells.size(); ++i) {
        if (expected.core[i]) continue;
        if (expected.claims[i].empty()) {
            ASSERT_EQ(found[i], -1) << "noise " << i;
            continue;
        }
        bool claimed = false;
        for (const int c : expected.claims[i]) claimed = claimed || clusterOf[c] == found[i];
        ASSERT_TRUE(claimed) << "border " << i;
    }
    const int clusters = static_cast<int>(clusterOf.size());
    for (int c = 0; c < clusters; ++c) EXPECT_EQ(distinct.count(c), 1u) << "numbers from 0";
}
}  // namespace

TEST(DensityClustering, AgreesWithTheTextbookOnRandomCells)
{
    std::mt19937 random(8);
    for (const int radius : {1, 2, 9})
        for (int run = 0; run < 40; ++run) {
            std::uniform_int_distribution<int32_t> place(-7 - 2 * radius, 7 + 2 * radius);
            std::uniform_real_distribution<float> weight(0.1F, 3), core(1, 12);
            std::set<VoxelCoord> coords;
            for (int i = 0; i < 250; ++i)
                coords.insert({place(random), place(random), place(random)});
            std::vector<WeightedCell> cells;
            for (const auto& c : coords) cells.push_back({c, weight(random), core(random)});
            std::shuffle(cells.begin(), cells.end(), random);
            expectClustering(cells, radius);
        }
}

TEST(DensityClustering, SeparatesWhatNoCoreConnects)
{
    // Two bars of three cells, one cell between them that touches both but is no core.
    std::vector<WeightedCell> cells;
    for (const int x : {-3, -2, -1, 1, 2, 3}) cells.push_back({{x, 0, 0}, 2, 4});
    cells.push_back({{0, 0, 0}, 1, 100});
    const auto clusters = clusterByDensity(cells, 1);
    EXPECT_EQ(std::vector<int>(clusters.begin(), clusters.begin() + 6),
              (std::vector<int>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(clusters[6], 0) << "the first to reach it";
}

TEST(DensityClustering, CellsReachedFromNoCoreAreNoise)
{
    const std::vector<WeightedCell> cells = {{{0, 0, 0}, 1, 2}, {{5, 0, 0}, 3, 2}};
    EXPECT_EQ(clusterByDensity(cells, 1), (std::vector<int>{-1, 0}));
    EXPECT_TRUE(clusterByDensity({}, 1).empty());
}

TEST(DensityClustering, HeaviestClusterIsByWeightNotByNumberOfCells)
{
    const std::vector<WeightedCell> cells = {
        {{0, 0, 0}, 1, 0}, {{1, 0, 0}, 1, 0}, {{9, 0, 0}, 5, 0}, {{20, 0, 0}, 99, 1000}};
    const std::vector<int> clusters = {0, 0, 1, -1};
    EXPECT_EQ(heaviestCluster(cells, clusters), 1);
    EXPECT_EQ(heaviestCluster(cells, {-1, -1, -1, -1}), -1);
    EXPECT_EQ(heaviestCluster({{{0, 0, 0}, 2, 0}, {{9, 0, 0}, 2, 0}}, {0, 1}), 0);
    EXPECT_EQ(heaviestCluster({}, {}), -1);
}
