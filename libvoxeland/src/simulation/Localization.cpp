// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Localization.h"

#include <Eigen/Dense>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <array>
#include <cmath>

using mrpt::math::CMatrixDouble66;
using mrpt::math::TPose3D;
using mrpt::poses::CPose3D;
using mrpt::poses::CPose3DPDFGaussian;

namespace voxeland::simulation
{
namespace
{
constexpr float DEG = 3.14159265F / 180;

/** Standard deviations of an error in the camera's frame [m, rad]; heights and tilts are easier. */
struct Sigmas
{
    float x, y, z, yaw, pitch, roll;
};

TPose3D errorOf(const Sigmas& s, Random& random)
{
    TPose3D error;  // one by one: the order of random numbers matters
    error.x = random.normal(s.x);
    error.y = random.normal(s.y);
    error.z = random.normal(s.z);
    error.yaw = random.normal(s.yaw);
    if (s.pitch > 0) error.pitch = random.normal(s.pitch);
    if (s.roll > 0) error.roll = random.normal(s.roll);
    return error;
}

/** Covariance of a pose, with that one, that had an exact movement and an error added to it. */
PoseCovariance moved(const ReportedPose& from, const CPose3D& movement, const Sigmas& s)
{
    CPose3DPDFGaussian pdf{CPose3D(from.pose)};
    if (from.covariance) pdf.cov = *from.covariance;
    pdf += movement;
    CPose3DPDFGaussian error{CPose3D()};
    const std::array<float, 6> sigmas = {s.x, s.y, s.z, s.yaw, s.pitch, s.roll};
    for (int i = 0; i < 6; ++i) {
        const double sigma = static_cast<double>(sigmas[static_cast<size_t>(i)]);
        error.cov(i, i) = sigma * sigma;
    }
    pdf += error;
    return std::make_shared<const CMatrixDouble66>(pdf.cov);
}
}  // namespace

std::vector<ReportedPose> drifting(const std::vector<TPose3D>& poses, const DriftOptions& options,
                                   Random random)
{
    std::vector<ReportedPose> result;
    for (size_t i = 0; i < poses.size(); ++i) {
        if (!options.enabled || i == 0) {
            result.push_back({poses[i], nullptr});
            continue;
        }
        const ReportedPose& last = result.back();
        const CPose3D step = CPose3D(poses[i]) - CPose3D(poses[i - 1]);
        const auto root = static_cast<float>(std::sqrt(step.norm()));
        const float t = options.translation * root, r = options.rotation * DEG * root;
        const Sigmas sigmas{t, t, t / 3, r, 0, 0};
        const CPose3D error(errorOf(sigmas, random));
        result.push_back(
            {(CPose3D(last.pose) + step + error).asTPose(), moved(last, step, sigmas)});
    }
    return result;
}

std::vector<ReportedPose> jittering(std::vector<ReportedPose> poses, const JitterOptions& options,
                                    Random random)
{
    if (!options.enabled) return poses;
    float level = 0;
    for (size_t i = 0; i < poses.size(); ++i) {
        if (i % static_cast<size_t>(options.period) == 0)
            level = std::pow(random.uniform(0, 1), 3.0F);
        const float t = options.translation * level, r = options.rotation * DEG * level;
        const Sigmas sigmas{t, t, t / 3, r, r / 3, r / 3};
        const CPose3D error(errorOf(sigmas, random));
        poses[i] = {(CPose3D(poses[i].pose) + error).asTPose(), moved(poses[i], CPose3D(), sigmas)};
    }
    return poses;
}
}  // namespace voxeland::simulation
