// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/VoxelEvidence.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <utility>

using namespace voxeland;

namespace
{
std::map<instance_id_t, float> contentOf(const VoxelEvidence& evidence)
{
    std::map<instance_id_t, float> content;
    for (const auto& e : evidence) content[e.instance] = e.alpha;
    return content;
}

VoxelEvidence evidenceFor(uint32_t instances)
{
    VoxelEvidence evidence;
    for (uint32_t i = 0; i < instances; ++i) evidence.add(i, static_cast<float>(i + 1));
    return evidence;
}
}  // namespace

TEST(VoxelEvidence, BehavesLikeAStandardMap)
{
    std::mt19937 random(21);
    std::uniform_int_distribution<instance_id_t> anyInstance(0, 11);
    for (int run = 0; run < 30; ++run) {
        VoxelEvidence evidence;
        std::map<instance_id_t, float> reference;
        for (int i = 0; i < 200; ++i) {
            const instance_id_t id = anyInstance(random);
            if (i % 3 == 0) {
                const auto at = reference.find(id);
                ASSERT_EQ(evidence.remove(id), at == reference.end() ? 0 : at->second);
                reference.erase(id);
            } else {
                const auto alpha = static_cast<float>(1 + i % 5);
                ASSERT_EQ(evidence.add(id, alpha), reference.count(id) == 0);
                reference[id] += alpha;
            }
            ASSERT_EQ(contentOf(evidence), reference);
            ASSERT_EQ(evidence.size(), reference.size());
            float total = 0;
            for (const auto& [instance, alpha] : reference) {
                ASSERT_EQ(evidence.alphaOf(instance), alpha);
                total += alpha;
            }
            ASSERT_EQ(evidence.total(), total);
            for (const auto* e = evidence.begin(); e + 1 < evidence.end(); ++e)
                ASSERT_LT(e->instance, (e + 1)->instance);
        }
    }
}

TEST(VoxelEvidence, CopiesAndMovesKeepEverything)
{
    for (const uint32_t n : {0u, 1u, 4u, 5u, 8u, 9u, 40u}) {
        const VoxelEvidence original = evidenceFor(n);
        const auto content = contentOf(original);
        ASSERT_EQ(content.size(), n);

        VoxelEvidence copy(original);
        copy.add(1000, 1);
        EXPECT_EQ(contentOf(original), content) << "a copy is independent";
        copy.remove(1000);
        EXPECT_EQ(contentOf(copy), content);

        VoxelEvidence moved(std::move(copy));
        EXPECT_EQ(contentOf(moved), content);

        for (const uint32_t before : {0u, 3u, 20u}) {
            VoxelEvidence assigned = evidenceFor(before);
            assigned = original;
            EXPECT_EQ(contentOf(assigned), content);
            assigned = evidenceFor(n + 1);
            EXPECT_EQ(assigned.size(), n + 1);
            const VoxelEvidence& itself = assigned;
            assigned = itself;
            EXPECT_EQ(assigned.size(), n + 1);
        }
    }
}

TEST(VoxelEvidence, StaysFinite)
{
    constexpr float MOST = std::numeric_limits<float>::max();
    VoxelEvidence evidence;
    evidence.add(1, MOST);
    evidence.add(1, MOST);
    EXPECT_EQ(evidence.alphaOf(1), MOST);
}

TEST(VoxelEvidence, FourEntriesNeedNoHeap)
{
    EXPECT_EQ(evidenceFor(4).heapMemory(), 0u);
    EXPECT_GT(evidenceFor(5).heapMemory(), 5 * sizeof(VoxelEvidence::Entry));
}

TEST(VoxelEvidence, WinnerIsTheFirstOfTheStrongestAndUnknownTheLast)
{
    VoxelEvidence evidence;
    EXPECT_EQ(evidence.strongest(), UNKNOWN_INSTANCE);
    EXPECT_EQ(evidence.total(), 0);
    evidence.add(UNKNOWN_INSTANCE, 2);
    EXPECT_EQ(evidence.strongest(), UNKNOWN_INSTANCE);
    evidence.add(7, 2);
    EXPECT_EQ(evidence.strongest(), 7u) << "unknown loses ties";
    evidence.add(3, 2);
    EXPECT_EQ(evidence.strongest(), 3u) << "the instance with the smaller id was seen first";
    evidence.add(7, 0.5F);
    EXPECT_EQ(evidence.strongest(), 7u);
    evidence.add(UNKNOWN_INSTANCE, 1);
    EXPECT_EQ(evidence.strongest(), UNKNOWN_INSTANCE);
}
