// SPDX-License-Identifier: BSD-3-Clause
/** Displacements by hand, by finite differences of MRPT's poses, and by displacing poses. */
#include "voxeland/base/errors.h"
#include "voxeland/observations/PoseUncertainty.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <mrpt/poses/CPose3D.h>

#include <array>
#include <cmath>
#include <random>

using namespace voxeland;
using mrpt::math::CMatrixDouble66;
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

namespace
{
using Angles = std::array<double, 6>;  //!< x, y, z, yaw, pitch, roll

CPose3D poseOf(const Angles& p)
{
    return {p[0], p[1], p[2], p[3], p[4], p[5]};
}

/** Some covariance in which everything depends on everything. \param scale of its deviations */
CMatrixDouble66 someCovariance(double scale, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, scale);
    Eigen::Matrix<double, 6, 6> root;
    for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = normal(random);
    CMatrixDouble66 covariance;
    covariance.asEigen() = root * root.transpose();
    return covariance;
}

CMatrixDouble66 diagonal(const Angles& sigmas)
{
    CMatrixDouble66 covariance;
    covariance.setZero();
    for (int i = 0; i < 6; ++i) covariance(i, i) = std::pow(sigmas[static_cast<size_t>(i)], 2);
    return covariance;
}

const Angles POSE = {1, -2, 0.5, 0.8, -0.4, 0.3};
const TPoint3D SEEN = {2.5, 0.3, -0.7};  //!< from the robot
}  // namespace

TEST(PoseUncertainty, ByHand)
{
    const CPose3D ahead(1, 2, 3, 0, 0, 0);
    const TPoint3D point(5, 5, 9);  // 4 ahead, 3 to the left, 6 up
    const auto displaced = [&](const Angles& sigmas) {
        return PoseUncertainty(ahead, diagonal(sigmas)).displacement(point);
    };
    EXPECT_EQ(displaced({}), 0);
    EXPECT_NEAR(displaced({0.01, 0.02, 0.02, 0, 0, 0}), 0.03, 1e-12);
    EXPECT_NEAR(displaced({0, 0, 0, 0.01, 0, 0}), 0.05, 1e-12) << "5 m from the axis of yaw";
    EXPECT_NEAR(displaced({0, 0, 0, 0, 0.01, 0}), 0.01 * std::hypot(4, 6), 1e-12);
    EXPECT_NEAR(displaced({0, 0, 0, 0, 0, 0.01}), 0.01 * std::hypot(3, 6), 1e-12);

    CMatrixDouble66 lever = diagonal({0, 0.1, 0, 0.025, 0, 0});
    lever(1, 3) = lever(3, 1) = -0.1 * 0.025;  // it moves left as it turns right, about 4 m ahead
    EXPECT_NEAR(PoseUncertainty(ahead, lever).displacement({5, 2, 3}), 0, 1e-9);
}

TEST(PoseUncertainty, IsTheTraceOfThePropagatedCovariance)
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937_64 random(100 + seed);
        std::uniform_real_distribution<double> any(-1.5, 1.5);
        Angles p;
        for (double& value : p) value = any(random);
        const TPoint3D seen(3 * any(random), 3 * any(random), 3 * any(random));
        const CMatrixDouble66 covariance = someCovariance(0.05, seed);
        Eigen::Matrix<double, 3, 6> J;
        for (size_t i = 0; i < 6; ++i) {
            constexpr double STEP = 1e-6;
            Angles more = p, less = p;
            more[i] += STEP;
            less[i] -= STEP;
            const TPoint3D d = poseOf(more).composePoint(seen) - poseOf(less).composePoint(seen);
            for (size_t row = 0; row < 3; ++row)
                J(static_cast<int>(row), static_cast<int>(i)) = d[row] / (2 * STEP);
        }
        const double expected = std::sqrt((J * covariance.asEigen() * J.transpose()).trace());
        const CPose3D pose = poseOf(p);
        EXPECT_NEAR(PoseUncertainty(pose, covariance).displacement(pose.composePoint(seen)),
                    expected, 1e-6);
    }
}

TEST(PoseUncertainty, IsHowFarPointsAreDisplaced)
{
    const CMatrixDouble66 covariance = someCovariance(0.004, 7);
    const Eigen::Matrix<double, 6, 6> root = covariance.asEigen().llt().matrixL();
    const CPose3D pose = poseOf(POSE);
    const TPoint3D where = pose.composePoint(SEEN);
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    constexpr int RUNS = 40000;
    double squares = 0;
    for (int run = 0; run < RUNS; ++run) {
        Eigen::Matrix<double, 6, 1> z;
        for (int i = 0; i < 6; ++i) z(i) = normal(random);
        const Eigen::Matrix<double, 6, 1> error = root * z;
        Angles p = POSE;
        for (int i = 0; i < 6; ++i) p[static_cast<size_t>(i)] += error(i);
        squares += std::pow((poseOf(p).composePoint(SEEN) - where).norm(), 2);
    }
    const double expected = PoseUncertainty(pose, covariance).displacement(where);
    EXPECT_NEAR(std::sqrt(squares / RUNS) / expected, 1, 0.02);
}

TEST(PoseUncertainty, RefusesWhatIsNoCovariance)
{
    CMatrixDouble66 covariance = diagonal({0.1, 0.1, 0.1, 0.1, 0.1, 0.1});
    EXPECT_NO_THROW(PoseUncertainty(poseOf(POSE), covariance));
    covariance(2, 4) = std::nan("");
    EXPECT_THROW(PoseUncertainty(poseOf(POSE), covariance), InputError);
    covariance = diagonal({0.1, 0.1, 0.1, 0.1, 0.1, 0.1});
    covariance(3, 3) = -1e-3;
    EXPECT_THROW(PoseUncertainty(poseOf(POSE), covariance), InputError);
}
