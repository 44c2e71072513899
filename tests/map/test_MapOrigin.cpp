// SPDX-License-Identifier: BSD-3-Clause
/** Where a map's frame lies in the world. */
#include "support/MapBytes.h"

#include <gtest/gtest.h>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
SemanticVoxelMap readAgain(const SemanticVoxelMap& map)
{
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    map.writeTo(archive);
    stream.Seek(0);
    SemanticVoxelMap read;
    read.readFrom(archive);
    return read;
}
}  // namespace

TEST(MapOrigin, isThatOfTheWorldWhereThePlaceIsNear)
{
    SemanticVoxelMap map;
    map.placeNear({1100, -26000, 3});
    EXPECT_EQ(map.origin(), TPoint3D(0, 0, 0)) << "half of 2^20 voxels of 5 cm are 26214.4 m";
}

TEST(MapOrigin, isTheCornerOfABlockNearAFarPlace)
{
    SemanticVoxelMap map;
    map.placeNear({450000.3, 5572094.1, 120});
    // Blocks are 0.4 m wide: 1125000.75 and 13930235.25 of them.
    EXPECT_NEAR(map.origin().x, 450000.4, 1e-8);
    EXPECT_NEAR(map.origin().y, 5572094, 1e-8);
    EXPECT_EQ(map.origin().z, 0) << "each axis on its own";
    EXPECT_EQ(map.inWorld(map.inMap({450001, 5572090, 3})), TPoint3D(450001, 5572090, 3));
}

TEST(MapOrigin, staysOnceSomethingIsMapped)
{
    SemanticVoxelMap map;
    map.placeNear({450000, 0, 0});
    map.addEvidence({1, 2, 3}, UNKNOWN_INSTANCE, 1);
    map.placeNear({0, 0, 0});
    EXPECT_NEAR(map.origin().x, 450000, 1e-8);
    map.clear();
    EXPECT_EQ(map.origin().x, 0);
}

TEST(MapOrigin, isStored)
{
    SemanticVoxelMap map;
    map.placeNear({450000, 5572094, 0});
    map.addEvidence({1, 2, 3}, UNKNOWN_INSTANCE, 1);
    EXPECT_EQ(readAgain(map).origin(), map.origin());
}

TEST(MapOrigin, theOutermostVoxelsCanBeReadAgain)
{
    constexpr int32_t END = MAX_VOXEL_COORD;
    SemanticVoxelMap map;
    map.addEvidence({-END, -END, -END}, UNKNOWN_INSTANCE, 1);
    map.addEvidence({END, END, END}, UNKNOWN_INSTANCE, 1);
    EXPECT_EQ(test::bytesOf(readAgain(map)), test::bytesOf(map));
}
