// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "support/HandMadeMap.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <limits>
#include <sstream>

using namespace voxeland;
using mrpt::math::TPoint3D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationPointCloud;
using mrpt::poses::CPose3D;

namespace
{
/** A map whose one occupied voxel has its centre at (1.025, 0.025, 0.025). */
CVoxelandMap oneVoxel()
{
    CVoxelandMap map;
    test::setVoxel(map.editMap(), {20, 0, 0});
    map.likelihoodOptions.max_points = map.likelihoodOptions.independent_points = 0;
    return map;
}

CObservationPointCloud cloudOf(const std::vector<TPoint3D>& points)
{
    CObservationPointCloud cloud;
    cloud.pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (const TPoint3D& p : points) cloud.pointcloud->insertPoint(p);
    return cloud;
}

/** A room of 4 m by 5 m with a pillar, its walls at the voxels around it, 1 m high. */
CVoxelandMap room()
{
    CVoxelandMap map;
    SemanticVoxelMap& voxels = map.editMap();
    const auto column = [&](int x, int y) {
        for (int z = 0; z < 20; ++z) test::setVoxel(voxels, {x, y, z});
    };
    for (int y = -1; y <= 100; ++y) column(-1, y), column(80, y);
    for (int x = -1; x <= 80; ++x) column(x, -1), column(x, 100);
    for (int y = 60; y < 70; ++y)
        for (int x = 50; x < 60; ++x) column(x, y);
    return map;
}

/** Distance from inside that room to what is met at an angle [m]. */
double castRay(double x, double y, double angle)
{
    const auto free = [](double px, double py) {
        const bool pillar = px >= 2.5 && px <= 3.0 && py >= 3.0 && py <= 3.5;
        return px > -0.025 && px < 4.025 && py > -0.025 && py < 5.025 && !pillar;
    };
    double range = 0;
    while (free(x + range * std::cos(angle), y + range * std::sin(angle))) range += 0.001;
    return range;
}

CObservation2DRangeScan laserScan(double x, double y, double heading)
{
    CObservation2DRangeScan scan;
    scan.aperture = static_cast<float>(M_PI);
    scan.rightToLeft = true;
    scan.maxRange = 20;
    scan.sensorPose = CPose3D(0, 0, 0.5, 0, 0, 0);
    scan.resizeScan(181);
    for (size_t i = 0; i < 181; ++i) {
        const double angle = heading + (static_cast<double>(i) - 90) * M_PI / 180;
        scan.setScanRange(i, static_cast<float>(castRay(x, y, angle)));
        scan.setScanRangeValidity(i, true);
    }
    return scan;
}
}  // namespace

TEST(Likelihood, IsTheFormulasByHand)
{
    CVoxelandMap map = oneVoxel();
    auto cloud = cloudOf({{1.025, 0.025, 0.025}, {1.125, 0.025, 0.025}, {7, 0, 0}});
    // Distances 0, 0.1 and, capped, 0.3 m with a standard deviation of 0.1 m:
    // 1; 0.95 exp(-0.5) + 0.05 = 0.626204; 0.95 exp(-4.5) + 0.05 = 0.060554.
    constexpr double SUM = -0.468079 - 2.804225;
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, {}), SUM, 1e-5);
    map.likelihoodOptions.independent_points = 2;
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, {}), SUM * 2 / 3, 1e-5);
    map.likelihoodOptions.max_range = 5;
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, {}), -0.468079, 1e-5);
    // Twice the standard deviation: 0.95 exp(-0.125) + 0.05 = 0.888372.
    map.likelihoodOptions.sigma_dist = 0.2;
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, {}), -0.118364, 1e-5);
    // Half outliers: 0.5 exp(-0.125) + 0.5 = 0.941249.
    map.likelihoodOptions.outliers = 0.5;
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, {}), -0.060548, 1e-5);
}

TEST(Likelihood, PointsAreInTheSensorsFrameAndTheSensorIsOnTheRobot)
{
    const CVoxelandMap map = oneVoxel();
    const CPose3D sensor(0.3, -0.2, 0.5, 0.4, 0.3, -0.2), robot(1, 2, 0, -1, 0.1, 0);
    const TPoint3D inMap(1.125, 0.025, 0.025);
    auto cloud = cloudOf({(robot + sensor).inverseComposePoint(inMap)});
    cloud.sensorPose = sensor;
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, robot), -0.468079, 1e-4);
}

TEST(Likelihood, OfNothingMeasuredOrNothingMapped)
{
    const CVoxelandMap map = oneVoxel();
    EXPECT_EQ(map.computeObservationLikelihood(cloudOf({}), {}), 0);
    EXPECT_EQ(map.computeObservationLikelihood(CObservationPointCloud(), {}), 0);
    CVoxelandMap empty;
    empty.likelihoodOptions = map.likelihoodOptions;
    EXPECT_NEAR(empty.computeObservationLikelihood(cloudOf({{1, 0, 0}}), {}), -2.804225, 1e-5);
}

TEST(Likelihood, PointsThatAreNotFiniteTellNothing)
{
    CVoxelandMap map = oneVoxel();
    map.likelihoodOptions.independent_points = 2;
    constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
    constexpr double INF = std::numeric_limits<double>::infinity();
    const TPoint3D a(1.125, 0.025, 0.025), b(1.025, 0.025, 0.025), c(7, 0, 0);
    const auto clean = cloudOf({a, b, c});
    const auto holed = cloudOf(
        {a, {NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER}, b, {1, 0, NOT_A_NUMBER}, c, {-INF, 0, 0}});
    EXPECT_EQ(map.computeObservationLikelihood(holed, {}),
              map.computeObservationLikelihood(clean, {}));
}

TEST(Likelihood, FollowsTheMap)
{
    CVoxelandMap map = oneVoxel();
    const auto cloud = cloudOf({{3.025, 0.025, 0.025}});
    const CVoxelandMap before = map;
    EXPECT_LT(map.computeObservationLikelihood(cloud, {}), -2);
    test::setVoxel(map.editMap(), {60, 0, 0});
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, {}), 0, 1e-9);
    EXPECT_LT(before.computeObservationLikelihood(cloud, {}), -2) << "the copy is another map";
}

TEST(Likelihood, ADepthImageIsAsGoodAsItsPoints)
{
    CVoxelandMap map;
    for (int y = -60; y < 60; ++y)
        for (int z = -45; z < 45; ++z) test::setVoxel(map.editMap(), {40, y, z});
    map.likelihoodOptions.max_points = map.likelihoodOptions.independent_points = 0;
    auto scan =
        test::makeScan([](int c, int r) { return c < 3 ? 0 : 1.8 + 0.003 * c + 0.002 * r; });
    scan->sensorPose = CPose3D(0.1, 0, 0.2, 0.05, 0, 0.02);
    mrpt::maps::CSimplePointsMap points;
    scan->unprojectInto(points);
    ASSERT_EQ(points.size(), 77u * 60);
    CObservationPointCloud cloud;
    cloud.pointcloud = std::make_shared<mrpt::maps::CSimplePointsMap>(points);
    cloud.sensorPose = scan->sensorPose;
    const CPose3D robot(0.02, 0.3, 0, 0.1, 0, 0);
    const double all = map.computeObservationLikelihood(*scan, robot);
    EXPECT_LT(all, -100);
    EXPECT_NEAR(all, map.computeObservationLikelihood(cloud, robot), 1e-3 * std::abs(all));

    // Some of the points, evenly spread, say what all say.
    map.likelihoodOptions.max_points = 300;
    map.likelihoodOptions.independent_points = 100;
    const double some = map.computeObservationLikelihood(*scan, robot);
    EXPECT_NEAR(some / 100, all / (77 * 60), 0.05 * std::abs(some) / 100);
    EXPECT_NEAR(map.computeObservationLikelihood(cloud, robot), some, 0.05 * std::abs(some));

    // A scan without an image may have points.
    scan->hasPoints3D = true;
    scan->points3D_x = {points.getPointsBufferRef_x().begin(), points.getPointsBufferRef_x().end()};
    scan->points3D_y = {points.getPointsBufferRef_y().begin(), points.getPointsBufferRef_y().end()};
    scan->points3D_z = {points.getPointsBufferRef_z().begin(), points.getPointsBufferRef_z().end()};
    scan->hasRangeImage = false;
    EXPECT_NEAR(map.computeObservationLikelihood(*scan, robot),
                map.computeObservationLikelihood(cloud, robot), 1e-3 * std::abs(some));
    scan->hasPoints3D = false;
    EXPECT_FALSE(map.canComputeObservationLikelihood(*scan));
}

TEST(Likelihood, ExternalDepthImagesAreLoadedAndStay)
{
    const test::TemporaryFolder folder;
    const CVoxelandMap map = room();
    const auto scan = test::makeScan([](int, int) { return 2.0; });
    const CPose3D robot(2, 1, 0.5, M_PI / 2, 0, 0);
    const double inMemory = map.computeObservationLikelihood(*scan, robot);
    scan->rangeImage_convertToExternalStorage("depth.bin", folder.path().string() + "/");
    const std::string before = mrpt::img::CImage::getImagesPathBase();
    mrpt::img::CImage::setImagesPathBase(folder.path().string());
    scan->unload();
    ASSERT_EQ(scan->rangeImage.size(), 0u);
    EXPECT_DOUBLE_EQ(map.computeObservationLikelihood(*scan, robot), inMemory);
    EXPECT_GT(scan->rangeImage.size(), 0u);
    mrpt::img::CImage::setImagesPathBase(before);
}

TEST(Likelihood, ADepthImageOfAnotherSizeThanItsCalibrationIsRefused)
{
    const auto scan = test::makeScan([](int, int) { return 2.0; });
    scan->cameraParams.ncols = 90;
    EXPECT_THROW((void)room().computeObservationLikelihood(*scan, {}), InputError);
}

TEST(Likelihood, AVelodyneScanHasPoints)
{
    mrpt::obs::CObservationVelodyneScan scan;
    scan.point_cloud.x = {1.125F};
    scan.point_cloud.y = {0.025F};
    scan.point_cloud.z = {0.025F};
    EXPECT_TRUE(oneVoxel().canComputeObservationLikelihood(scan));
    EXPECT_NEAR(oneVoxel().computeObservationLikelihood(scan, {}), -0.468079, 1e-4);
}

TEST(Likelihood, ALaserScanIsLikeliestWhereItWasMade)
{
    const CVoxelandMap map = room();
    constexpr double X = 1.7, Y = 2.1, HEADING = 0.6;
    auto scan = laserScan(X, Y, HEADING);
    scan.setScanRange(7, 20);  // nothing met
    scan.setScanRangeValidity(8, false);
    const double atTruth = map.computeObservationLikelihood(scan, CPose3D(X, Y, 0, HEADING, 0, 0));
    for (double dx = -0.6; dx < 0.61; dx += 0.1)
        for (double dy = -0.6; dy < 0.61; dy += 0.1)
            for (double turn = -0.6; turn < 0.61; turn += 0.1) {
                if (std::abs(dx) + std::abs(dy) + std::abs(turn) < 0.01) continue;
                const CPose3D wrong(X + dx, Y + dy, 0, HEADING + turn, 0, 0);
                EXPECT_GT(atTruth, map.computeObservationLikelihood(scan, wrong) + 0.2) << wrong;
            }
}

TEST(Likelihood, OptionsAreReadCheckedAndPrinted)
{
    LikelihoodOptions o;
    o.loadFromConfigFile(mrpt::config::CConfigFileMemory(std::string(
                             "[s]\nsigma_dist = 0.25\nmax_points = 7\nindependent_points = 3\n")),
                         "s");
    EXPECT_EQ(o.sigma_dist, 0.25);
    EXPECT_EQ(o.max_points, 7u);
    EXPECT_EQ(o.independent_points, 3u);
    EXPECT_EQ(o.outliers, 0.05);
    mrpt::config::CConfigFileMemory saved;
    o.saveToConfigFile(saved, "t");
    LikelihoodOptions read;
    read.loadFromConfigFile(saved, "t");
    EXPECT_EQ(read.sigma_dist, 0.25);
    EXPECT_EQ(read.max_points, 7u);
    std::ostringstream text;
    o.dumpToTextStream(text);
    EXPECT_NE(text.str().find("sigma_dist = 0.25"), std::string::npos);
    for (const char* wrong : {"sigma_dits = 1", "sigma_dist = 0", "outliers = 1", "max_points = x"})
        EXPECT_THROW(read.loadFromConfigFile(
                         mrpt::config::CConfigFileMemory("[s]\n" + std::string(wrong) + "\n"), "s"),
                     ConfigurationError)
            << wrong;
}

TEST(Likelihood, OptionsOfMrptsIniReachTheMapAndItsCopies)
{
    const mrpt::config::CConfigFileMemory ini(
        std::string("[m]\nvoxelandMap_count = 1\n[m_voxelandMap_00_likelihoodOpts]\n"
                    "sigma_dist = 0.2\nmax_corr_distance = 0.5\noutliers = 0.1\nmax_points = 50\n"
                    "independent_points = 9\nmax_range = 6\n"));
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(ini, "m");
    std::ostringstream text;
    (*definitions.begin())->dumpToTextStream(text);
    EXPECT_NE(text.str().find("independent_points = 9"), std::string::npos) << text.str();
    mrpt::maps::CMultiMetricMap maps;
    maps.setListOfMaps(definitions);
    maps.mapByClass<CVoxelandMap>()->editMap() = room().map();
    const mrpt::maps::CMultiMetricMap copy = maps;
    const auto& o = copy.mapByClass<CVoxelandMap>()->likelihoodOptions;
    EXPECT_EQ(o.sigma_dist, 0.2);
    EXPECT_EQ(o.max_corr_distance, 0.5);
    EXPECT_EQ(o.outliers, 0.1);
    EXPECT_EQ(o.max_points, 50u);
    EXPECT_EQ(o.independent_points, 9u);
    EXPECT_EQ(o.max_range, 6);
    const auto scan = laserScan(1, 1, 0);
    const CPose3D pose(1.1, 1, 0, 0.1, 0, 0);
    EXPECT_LT(maps.computeObservationLikelihood(scan, pose), -0.1);
    EXPECT_EQ(copy.computeObservationLikelihood(scan, pose),
              maps.computeObservationLikelihood(scan, pose));
}
