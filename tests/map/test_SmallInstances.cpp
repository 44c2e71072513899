// SPDX-License-Identifier: BSD-3-Clause
#include "support/TinyMap.h"
#include "voxeland/map/MapQueries.h"
#include "voxeland/map/SmallInstances.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(SmallInstances, becomeUnknown)
{
    SemanticVoxelMap map = test::tinyMap();
    test::addVoxel(map, {0, 1, 0}, {{1, 5}});
    deactivateSmallInstances(map, 2);  // the cup wins one voxel only
    ASSERT_EQ(summarizeInstances(map).size(), 1U);
    EXPECT_EQ(summarizeInstances(map)[0].id, 1U);
    EXPECT_EQ(map.winner(*map.evidence({1, 0, 0})), UNKNOWN_INSTANCE);
    EXPECT_EQ(map.inactive().size(), 1U);
}

TEST(SmallInstances, whatTheyHideIsNotShownInstead)
{
    SemanticVoxelMap map = test::tinyMap();
    const instance_id_t hidden = map.createInstance().id;
    for (const auto& [id, instance] : map.instances())
        if (id != hidden) map.addEvidence({1, 0, 0}, id, 5);
    map.addEvidence({1, 0, 0}, hidden, 1);
    deactivateSmallInstances(map, 100);
    EXPECT_TRUE(summarizeInstances(map).empty());
}
