// SPDX-License-Identifier: BSD-3-Clause
/** The same frames near the origin of the world and at coordinates as of UTM. */
#include "exporters/GlbFile.h"
#include "exporters/GridFiles.h"
#include "exporters/MapPly.h"
#include "exporters/MapScene.h"
#include "exporters/OctoMapFile.h"
#include "exporters/PointsFile.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/answers/MapAnswers.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

using namespace voxeland;
using mrpt::math::TPoint3D;
using voxeland::test::SmallFrame;

namespace
{
/** Whole blocks of 0.4 m from the origin: 1125000 and 13930235 of them. */
const TPoint3D UTM(450000, 5572094, 0);

std::vector<SmallFrame> framesAt(const TPoint3D& place, int count = 8)
{
    auto frames = test::smallFrames(count);
    for (auto& f : frames) f.pose->pose.mean = relativeTo(-place, f.pose->pose.mean);
    return frames;
}

void insert(CVoxelandMap& map, const std::vector<SmallFrame>& frames)
{
    for (const auto& f : frames) {
        map.insertObservation(*f.scan, f.pose->pose.mean);
        map.insertObservation(*f.instances, f.pose->pose.mean);
    }
}

CVoxelandMap mapAt(const TPoint3D& place)
{
    CVoxelandMap map{MapperConfig()};
    insert(map, framesAt(place));
    return map;
}

/** Centres of the occupied voxels, in the world and moved back by a place. */
std::vector<TPoint3D> voxelsFrom(const SemanticVoxelMap& map, const TPoint3D& place)
{
    std::vector<TPoint3D> centers;
    map.forEachVoxel([&](const VoxelCoord& v, const auto&...) {
        centers.push_back(map.inWorld(voxelCenter<TPoint3D>(v, map.resolution())) - place);
    });
    std::sort(centers.begin(), centers.end(), [](const TPoint3D& a, const TPoint3D& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return centers;
}

void expectSame(const std::vector<TPoint3D>& a, const std::vector<TPoint3D>& b)
{
    ASSERT_EQ(a.size(), b.size());
    size_t apart = 0;
    for (size_t i = 0; i < a.size(); ++i) apart += (a[i] - b[i]).norm() < 1e-6 ? 0U : 1U;
    EXPECT_EQ(apart, 0U);
}
}  // namespace

TEST(FarFromOrigin, theMapIsTheSame)
{
    const CVoxelandMap near = mapAt({}), far = mapAt(UTM);
    EXPECT_EQ(near.map().origin(), TPoint3D());
    EXPECT_EQ(far.counts().frames, 8U);
    expectSame(voxelsFrom(near.map(), {}), voxelsFrom(far.map(), UTM));
    const auto here = listInstances(near.map()), there = listInstances(far.map());
    ASSERT_EQ(here.size(), there.size());
    for (size_t i = 0; i < here.size(); ++i) {
        EXPECT_NEAR((here[i].summary.centroid + UTM - there[i].summary.centroid).norm(), 0, 1e-6);
        EXPECT_NEAR((here[i].box.center + UTM - there[i].box.center).norm(), 0, 1e-6);
        const PlaceAnswer place = askPlace(far.map(), there[i].summary.centroid);
        EXPECT_LT((place.center - there[i].summary.centroid).norm(), 0.05);
    }
}

TEST(FarFromOrigin, rawlogsAreMappedAsObservationsAre)
{
    const test::TemporaryFolder folder;
    test::writeRawlog(folder.file("far.rawlog"), framesAt(UTM));
    CVoxelandMap map{MapperConfig()};
    RawlogFrameSource source(folder.file("far.rawlog"), map.withCamera(map.mapper().config().input),
                             {});
    mapRawlog(source, map, [](const StageTimes&) {});
    expectSame(voxelsFrom(map.map(), UTM), voxelsFrom(mapAt({}).map(), {}));
}

TEST(FarFromOrigin, framesTheMapCannotHoldAreLeftOutAndCounted)
{
    // 2^20 voxels of 5 cm are 52428.8 m: the first camera is inside, what it sees is not.
    auto frames = framesAt({});
    for (const TPoint3D& place : {TPoint3D(52428, 0, 0), UTM, TPoint3D(9e8, 0, 0)}) {
        SmallFrame f = framesAt(place, 1)[0];
        f.pose->timestamp = f.scan->timestamp = f.instances->timestamp =
            mrpt::Clock::fromDouble(2000 + static_cast<double>(frames.size()));
        frames.push_back(f);
    }
    const test::TemporaryFolder folder;
    test::writeRawlog(folder.file("leaves.rawlog"), frames);
    CVoxelandMap map{MapperConfig()};
    RawlogFrameSource source(folder.file("leaves.rawlog"),
                             map.withCamera(map.mapper().config().input), {});
    const MappedInput met = mapRawlog(source, map, [](const StageTimes&) {});
    EXPECT_EQ(met.leftOut.count(), 3U);
    EXPECT_NE(met.leftOut.first().find("farther off than the map can hold"), std::string::npos);
    EXPECT_EQ(map.counts().frames, 8U);
    expectSame(voxelsFrom(map.map(), {}), voxelsFrom(mapAt({}).map(), {}));
}

TEST(FarFromOrigin, likelihoodsAreTheSame)
{
    const CVoxelandMap near = mapAt({}), far = mapAt(UTM);
    const SmallFrame here = framesAt({}, 1)[0], there = framesAt(UTM, 1)[0];
    EXPECT_NEAR(near.computeObservationLikelihood(*here.scan, here.pose->pose.mean),
                far.computeObservationLikelihood(*there.scan, there.pose->pose.mean), 1e-3);
    EXPECT_EQ(far.getAsSimplePointsMap(), nullptr);
}

TEST(FarFromOrigin, filesKeepTheirDigitsOrAreRefused)
{
    const test::TemporaryFolder folder;
    const CVoxelandMap far = mapAt(UTM);
    const SemanticVoxelMap& map = far.map();

    exportPly(map, folder.file("far.ply"));
    const std::string ply = test::readFile(folder.file("far.ply"));
    EXPECT_NE(ply.find("property double x\n"), std::string::npos);
    double y = 0;
    std::memcpy(&y, ply.data() + ply.find("end_header\n") + 11 + sizeof(y), sizeof(y));
    EXPECT_NEAR(y, UTM.y, 10);
    EXPECT_NEAR(std::remainder(y - 0.025, 0.05), 0, 1e-6) << "the centre of a voxel";

    const HeightSlice local = sliceOf(map, GravityAlignedFrame(), {-2, 2}),
                      slice = inWorld(local, map);
    WrittenFiles written;
    exportRosMap(slice, folder.file("far.yaml"), written);
    const std::string yaml = test::readFile(folder.file("far.yaml"));
    const double x = std::stod(yaml.substr(yaml.find("origin: [") + 9));
    EXPECT_NEAR(x, local.minX + map.origin().x, 1e-9);
    EXPECT_THROW(exportGridmap(slice, folder.file("far.gridmap")), ConfigurationError);
    EXPECT_THROW(exportOctoMap(map, folder.file("far.bt")), ConfigurationError);
    EXPECT_THROW(exportPoints(map, {}, folder.file("far.txt")), ConfigurationError);

    exportScene(map, GravityAlignedFrame(), folder.file("far.3Dscene"));
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile(folder.file("far.3Dscene")));
    const auto root = scene.getByClass<mrpt::opengl::CSetOfObjects>();
    ASSERT_TRUE(root);
    EXPECT_NEAR(root->getPoseX(), UTM.x, 1e-6);
    EXPECT_NEAR(root->getPoseY(), UTM.y, 1e-6);

    exportGlb(map, GravityAlignedFrame(), folder.file("far.glb"));
    // Turned to y up: (x, z, -y). The vertices are relative to it.
    EXPECT_NE(test::readFile(folder.file("far.glb")).find(",450000.0,0.0,-5572094.0,1.0]"),
              std::string::npos)
        << test::readFile(folder.file("far.glb")).substr(0, 600);
}
