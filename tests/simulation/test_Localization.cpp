// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Localization.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>

using namespace voxeland;
using namespace voxeland::simulation;
using mrpt::math::TPose3D;
using mrpt::poses::CPose3D;

namespace
{
/** 4 m ahead, and the same way back after a turn. */
std::vector<TPose3D> way()
{
    std::vector<TPose3D> poses;
    for (int i = 0; i <= 100; ++i) poses.emplace_back(0.04 * i, 0, 1, 0, 0.3, 0.1);
    for (int i = 0; i <= 100; ++i) poses.emplace_back(4 - 0.04 * i, 0.5, 1, 3, 0.3, 0);
    return poses;
}

/** How well the reported covariance explains the errors of a pose in many runs: the mean of
 *  e' C^-1 e over the number of dimensions, which is 1 where it is the truth; and how far a point
 *  2 m ahead is displaced, in units of what is expected. \param make poses, given a seed */
template <typename Make>
void expectTruthful(const Make& make, const std::vector<TPose3D>& truth, size_t index,
                    int dimensions)
{
    constexpr int RUNS = 600;
    double explained = 0, squares = 0, expectedSquares = 0;
    const CPose3D truePose(truth[index]);
    const mrpt::math::TPoint3D ahead(2, 0, 0), there = truePose.composePoint(ahead);
    for (uint64_t run = 0; run < RUNS; ++run) {
        const ReportedPose reported = make(run)[index];
        const TPose3D &p = reported.pose, &t = truth[index];
        Eigen::Matrix<double, 6, 1> e;
        e << p.x - t.x, p.y - t.y, p.z - t.z, std::remainder(p.yaw - t.yaw, 2 * M_PI),
            p.pitch - t.pitch, p.roll - t.roll;
        const Eigen::Matrix<double, 6, 6> C = reported.covariance->asEigen();
        explained += e.dot(C.completeOrthogonalDecomposition().pseudoInverse() * e);
        squares += std::pow((CPose3D(p).composePoint(ahead) - there).norm(), 2);
        const PoseUncertainty uncertainty(CPose3D(p), *reported.covariance);
        expectedSquares += std::pow(uncertainty.displacement(CPose3D(p).composePoint(ahead)), 2);
    }
    EXPECT_NEAR(explained / RUNS / dimensions, 1, 0.1);
    EXPECT_NEAR(std::sqrt(squares / expectedSquares), 1, 0.1);
}
}  // namespace

TEST(Drift, IsNothingUnlessAskedFor)
{
    const auto truth = way();
    const auto poses = jittering(drifting(truth, {}, Random(1)), {}, Random(1));
    ASSERT_EQ(poses.size(), truth.size());
    for (size_t i = 0; i < truth.size(); ++i) {
        EXPECT_EQ(poses[i].pose, truth[i]);
        EXPECT_EQ(poses[i].covariance, nullptr);
    }
}

TEST(Drift, GrowsWithTheSquareRootOfTheWay)
{
    std::vector<TPose3D> poses;
    for (int i = 0; i <= 100; ++i) poses.emplace_back(0.04 * i, 0, 1, 0, 0, 0);  // 4 m ahead
    DriftOptions options;
    options.enabled = true;
    options.rotation = 0;
    constexpr int RUNS = 2000;
    double squares = 0;
    for (uint64_t run = 0; run < RUNS; ++run) {
        const auto drifted = drifting(poses, options, Random(run));
        EXPECT_EQ(drifted.front().pose, poses.front());
        squares += std::pow(drifted.back().pose.y, 2);
        EXPECT_NEAR((*drifted.back().covariance)(1, 1), 0.02 * 0.02, 1e-7);
    }
    // 0.01 m after 1 m is 0.02 m after 4 m.
    EXPECT_NEAR(std::sqrt(squares / RUNS), 0.02, 5 * 0.02 / std::sqrt(2.0 * RUNS));
}

TEST(Drift, TellsTheTruthAboutItsErrors)
{
    const auto truth = way();
    DriftOptions options;
    options.enabled = true;
    expectTruthful([&](uint64_t run) { return drifting(truth, options, Random(run)); }, truth, 200,
                   6);
}

TEST(Jitter, TellsTheTruthAboutItsErrors)
{
    const auto truth = way();
    JitterOptions options;
    options.enabled = true;
    const auto make = [&](uint64_t run) {
        return jittering(drifting(truth, {}, Random(run)), options, Random(run));
    };
    expectTruthful(make, truth, 70, 6);
}

TEST(Jitter, HasErrorsOfItsOwnWhoseSizeChangesWithTime)
{
    const std::vector<TPose3D> truth(3000, TPose3D(1, 2, 1, 0.5, 0, 0));
    JitterOptions options;
    options.enabled = true;
    const auto poses = jittering(drifting(truth, {}, Random(1)), options, Random(1));
    double products = 0, squares = 0;
    int changes = 0;
    for (size_t i = 1; i < poses.size(); ++i) {
        products += (poses[i].pose.x - 1) * (poses[i - 1].pose.x - 1);
        squares += std::pow(poses[i].pose.x - 1, 2);
        const bool same =
            poses[i].covariance->asEigen().isApprox(poses[i - 1].covariance->asEigen(), 0.2);
        changes += same ? 0 : 1;
        EXPECT_TRUE(same || i % 30 == 0) << i;
    }
    EXPECT_GT(changes, 80) << "of 99";
    EXPECT_LT(std::abs(products / squares), 0.2)
        << "neighbours have nothing to do with one another";
    // u^6 has the mean 1/7.
    EXPECT_NEAR(std::sqrt(squares / 3000), 0.1 / std::sqrt(7.0), 0.015);
}
