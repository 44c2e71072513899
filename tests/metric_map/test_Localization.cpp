// SPDX-License-Identifier: BSD-3-Clause
/** A robot finds itself in our map with MRPT's own particle filter. */
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/simulation/Simulator.h"

#include <gtest/gtest.h>
#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

using namespace voxeland;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

namespace
{
/** What a robot with a depth camera knows at a moment, and where it truly is. */
struct Moment
{
    std::shared_ptr<mrpt::obs::CObservation3DRangeScan> scan;
    CPose2D pose;
};

/** A robot on its way through a simulated room of 4 or 5 m. */
std::vector<Moment> tour(int frames)
{
    simulation::SimulationOptions options;
    options.scene.rooms = 1;
    options.camera.width = 160;
    options.camera.height = 120;
    options.camera.frames = frames;
    options.camera.frameRate = 3;
    const simulation::Simulator simulator(options);
    std::vector<Moment> moments;
    for (size_t i = 0; i < simulator.size(); ++i) {
        const auto frame = simulator.frame(i);
        const auto scan = simulator.record(frame).scan;
        // A robot drives on the floor: that the hand lifts and tilts is its sensor's doing.
        const CPose3D camera(frame.truePose);
        const CPose2D robot(camera.x(), camera.y(), camera.yaw());
        scan->sensorPose = (camera + scan->sensorPose) - CPose3D(robot);
        moments.push_back({scan, robot});
    }
    return moments;
}

/** The frames of even number as a map. */
CVoxelandMap mapOf(const std::vector<Moment>& moments)
{
    CVoxelandMap map{MapperConfig()};
    for (size_t i = 0; i < moments.size(); i += 2)
        map.insertObservation(*moments[i].scan, CPose3D(moments[i].pose));
    map.flush();
    return map;
}

/** What the wheels say of the way between two moments. */
mrpt::obs::CActionCollection odometry(const CPose2D& from, const CPose2D& to)
{
    mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
    model.gaussianModel.minStdXY = 0.02F;
    model.gaussianModel.minStdPHI = 0.02F;
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry(to - from, model);
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    return actions;
}
}  // namespace

TEST(Localization, ADepthScanIsLikeliestWithinAVoxelOfWhereItWasMade)
{
    const auto moments = tour(80);
    const CVoxelandMap map = mapOf(moments);
    const double voxel = map.map().resolution() + 0.001;
    for (size_t i = 1; i < moments.size(); i += 10) {
        const auto likeliest = [&](const mrpt::math::TPose3D& direction) {
            double best = -1e9, offset = 0;
            for (int step = -30; step <= 30; ++step) {
                const double x = 0.01 * step;
                const CPose3D error(x * direction.x, x * direction.y, x * direction.z,
                                    x * direction.yaw, x * direction.pitch, 0);
                const double l = map.computeObservationLikelihood(*moments[i].scan,
                                                                  CPose3D(moments[i].pose) + error);
                if (l > best) best = l, offset = x;
            }
            return offset;
        };
        EXPECT_NEAR(likeliest({1, 0, 0, 0, 0, 0}), 0, voxel) << i;
        EXPECT_NEAR(likeliest({0, 1, 0, 0, 0, 0}), 0, voxel) << i;
        EXPECT_NEAR(likeliest({0, 0, 1, 0, 0, 0}), 0, voxel) << i;
        EXPECT_NEAR(likeliest({0, 0, 0, 1, 0, 0}), 0, 0.021) << i;
        EXPECT_NEAR(likeliest({0, 0, 0, 0, 1, 0}), 0, 0.021) << i;
    }
}

TEST(Localization, AParticleFilterFindsTheRobotAnywhereInTheRoom)
{
    const auto moments = tour(80);
    const auto map = std::make_shared<CVoxelandMap>(mapOf(moments));
    const auto box = map->boundingBox();

    mrpt::random::getRandomGenerator().randomize(1);
    mrpt::slam::CMonteCarloLocalization2D robot;
    robot.options.metricMap = map;
    robot.resetUniform(box.min.x, box.max.x, box.min.y, box.max.y, -M_PI, M_PI, 3000);
    mrpt::bayes::CParticleFilter filter;
    filter.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
    filter.m_options.adaptiveSampleSize = false;

    double worstLater = 0, worstTurn = 0;
    for (size_t i = 1; i < moments.size(); i += 2) {  // those that are not in the map
        const auto way = odometry(moments[i < 2 ? i : i - 2].pose, moments[i].pose);
        mrpt::obs::CSensoryFrame seen;
        seen.insert(moments[i].scan);
        filter.executeOn(robot, &way, &seen);
        const CPose2D error = robot.getMeanVal() - moments[i].pose;
        if (i < moments.size() / 2) continue;  // it may look around first
        worstLater = std::max(worstLater, error.norm());
        worstTurn = std::max(worstTurn, std::abs(error.phi()));
    }
    EXPECT_LT(worstLater, 0.05) << "[m]";
    EXPECT_LT(worstTurn, 0.02) << "[rad]";
    RecordProperty("largest_error_mm", static_cast<int>(1000 * worstLater));
}
