// SPDX-License-Identifier: BSD-3-Clause
/** The scale of uncertainties, against all of them in order. */
#include "pictures/ViewColoring.h"
#include "support/TinyMap.h"
#include "voxeland/map/MapQueries.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** Red end of the bar of a colouring. */
double barOf(const SemanticVoxelMap& map, const std::string& name)
{
    const VoxelScene scene(map, GravityAlignedFrame({0, 0, 1}));
    double maximum = -1;
    forEachColoring(map, scene, [&](const ViewColoring& coloring) {
        EXPECT_EQ(coloring.colors.size(), scene.voxels().size()) << coloring.name;
        if (coloring.name == name) maximum = coloring.barMaximum;
    });
    return maximum;
}
}  // namespace

TEST(ViewColoring, TheBarEndsWhereOneInAHundredIsAbove)
{
    for (const int voxels : {1, 2, 99, 100, 101, 102, 300}) {
        SemanticVoxelMap map = emptyMap();
        const auto a = addInstance(map, {{"chair", 2}}), b = addInstance(map, {{"cup", 2}});
        std::vector<double> entropies;
        for (int i = 0; i < voxels; ++i) {
            const VoxelCoord v = {i % 20, i / 20, 0};
            addVoxel(map, v, {{a, 400.0F}, {b, static_cast<float>(20 + (i * 7) % voxels)}});
            entropies.push_back(instanceEntropy(map, *map.evidence(v)));
        }
        std::sort(entropies.begin(), entropies.end());
        const auto place = static_cast<size_t>(0.99 * (voxels - 1));
        EXPECT_EQ(barOf(map, "uncertainty_instances"), std::max(0.05, entropies[place])) << voxels;
    }
}
