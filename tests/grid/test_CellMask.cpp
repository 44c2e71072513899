// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/grid/CellMask.h"

#include <gtest/gtest.h>

#include <bitset>
#include <random>
#include <vector>

using namespace voxeland;

namespace
{
using Reference = std::bitset<BLOCK_CELLS>;

/** A random set, in both forms. */
std::pair<CellMask, Reference> randomSet(std::mt19937& random, double density)
{
    std::bernoulli_distribution in(density);
    std::pair<CellMask, Reference> set;
    for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
        if (!in(random)) continue;
        set.first.set(cell);
        set.second.set(static_cast<size_t>(cell));
    }
    return set;
}

void expectEqual(const CellMask& mask, const Reference& reference)
{
    for (int cell = 0; cell < BLOCK_CELLS; ++cell)
        ASSERT_EQ(mask.test(cell), reference.test(static_cast<size_t>(cell))) << cell;
    EXPECT_EQ(mask.count(), static_cast<int>(reference.count()));
    EXPECT_EQ(mask.any(), reference.any());
}
}  // namespace

TEST(CellMask, BehavesLikeABitset)
{
    std::mt19937 random(3);
    for (const double density : {0.0, 0.02, 0.5, 0.98, 1.0}) {
        const auto [a, refA] = randomSet(random, density);
        const auto [b, refB] = randomSet(random, 0.5);
        expectEqual(a, refA);
        expectEqual(a | b, refA | refB);
        expectEqual(a & b, refA & refB);
        expectEqual(a - b, refA & ~refB);
        EXPECT_EQ(a == b, refA == refB);
        EXPECT_TRUE(a == a);
    }
}

TEST(CellMask, RankCountsTheCellsBefore)
{
    std::mt19937 random(4);
    const auto [mask, reference] = randomSet(random, 0.3);
    int before = 0;
    for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
        ASSERT_EQ(mask.rank(cell), before) << cell;
        before += reference.test(static_cast<size_t>(cell)) ? 1 : 0;
    }
}

TEST(CellMask, VisitsCellsInIncreasingOrder)
{
    CellMask mask;
    const std::vector<int> cells = {0, 1, 63, 64, 127, 128, 300, 511};
    for (const int c : cells) mask.set(c);
    std::vector<int> visited;
    mask.forEach([&](int c) { visited.push_back(c); });
    EXPECT_EQ(visited, cells);
}

TEST(CellMask, CellsCanBeTakenOut)
{
    CellMask mask;
    mask.set(100);
    mask.set(511);
    mask.reset(100);
    mask.reset(7);
    EXPECT_FALSE(mask.test(100));
    EXPECT_EQ(mask.count(), 1);
}

TEST(CellMask, WordsHold64CellsEach)
{
    CellMask mask;
    mask.setWord(2, 0b101);
    EXPECT_TRUE(mask.test(128));
    EXPECT_FALSE(mask.test(129));
    EXPECT_TRUE(mask.test(130));
    EXPECT_EQ(mask.word(2), 5u);
    EXPECT_EQ(mask.word(3), 0u);
}
