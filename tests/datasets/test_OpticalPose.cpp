// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/OpticalPose.h"

#include <gtest/gtest.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>
#include <limits>

using namespace voxeland;
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

namespace
{
using Matrix = std::array<double, 16>;

const Matrix IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

void expectNear(const TPoint3D& a, const TPoint3D& b)
{
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(a.z, b.z, 1e-9);
}

TPoint3D fromOptical(const Matrix& m, const TPoint3D& p)
{
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
            m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}
}  // namespace

TEST(OpticalPose, aPointInFrontStaysWhereItIs)
{
    // Two metres in front, half a metre right, 0.3 m below the axis; the world is the camera's own
    // optical frame. In MRPT's axes that point is (2, -0.5, -0.3).
    const CPose3D pose(*poseFromOptical(IDENTITY));
    expectNear(pose.composePoint(TPoint3D(2, -0.5, -0.3)), {0.5, 0.3, 2});
}

TEST(OpticalPose, agreesWithTheMatrixOnEveryPoint)
{
    // 90 degrees about the world's z, then moved; then any rotation, built from axis and angle.
    const Matrix quarter = {0, -1, 0, 1.5, 1, 0, 0, -2, 0, 0, 1, 0.7, 0, 0, 0, 1};
    const double a = 0.8, c = std::cos(a), s = std::sin(a), u = 1 / std::sqrt(3.0);
    const double d = c + u * u * (1 - c), p = u * u * (1 - c) + u * s, m = u * u * (1 - c) - u * s;
    const Matrix any = {d, m, p, 3, p, d, m, 4, m, p, d, 5, 0, 0, 0, 1};
    for (const Matrix& matrix : {IDENTITY, quarter, any}) {
        const auto pose = poseFromOptical(matrix);
        ASSERT_TRUE(pose);
        for (const TPoint3D& q : {TPoint3D(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0.2, -0.4, 3}})
            expectNear(CPose3D(*pose).composePoint(TPoint3D(q.z, -q.x, -q.y)),
                       fromOptical(matrix, q));
    }
}

TEST(OpticalPose, refusesWhatIsNotRigid)
{
    EXPECT_TRUE(poseFromOptical(IDENTITY));
    const auto with = [](size_t i, double value) {
        Matrix m = IDENTITY;
        m[i] = value;
        return m;
    };
    EXPECT_TRUE(poseFromOptical(with(0, 1.0004))) << "rounding of text files";
    EXPECT_FALSE(poseFromOptical(with(0, 1.01))) << "scale";
    EXPECT_FALSE(poseFromOptical(with(1, 0.1))) << "shear";
    EXPECT_FALSE(poseFromOptical(with(10, -1))) << "reflection";
    EXPECT_FALSE(poseFromOptical(with(12, 0.5))) << "last row";
    EXPECT_FALSE(poseFromOptical(with(15, 0))) << "last row";
    EXPECT_FALSE(poseFromOptical(with(3, std::nan(""))));
    EXPECT_FALSE(poseFromOptical(with(7, -std::numeric_limits<double>::infinity())));
    EXPECT_FALSE(poseFromOptical(Matrix{}));
}
