// SPDX-License-Identifier: BSD-3-Clause
#include "observations/CameraCheck.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace voxeland;
using mrpt::img::TCamera;

namespace
{
TCamera camera(double fx, double fy, double cx = 319.5, double cy = 239.5)
{
    TCamera c;
    c.ncols = 640;
    c.nrows = 480;
    c.setIntrinsicParamsFromValues(fx, fy, cx, cy);
    return c;
}

TCamera distorted(double k1, double k2 = 0, double p1 = 0, double p2 = 0, double k3 = 0)
{
    TCamera c = camera(520, 520);
    c.setDistortionPlumbBob(k1, k2, p1, p2, k3);
    return c;
}

bool isRefusedFor(const TCamera& c, const std::string& what)
{
    return problemOf(c).find(what) != std::string::npos;
}
}  // namespace

TEST(CameraCheck, CamerasOfTheWorldPass)
{
    EXPECT_EQ(problemOf(camera(525, 525)), "");
    EXPECT_EQ(problemOf(camera(120, 120)), "") << "139 degrees wide";
    EXPECT_EQ(problemOf(camera(20000, 20000)), "") << "a telephoto lens";
    // Those of TUM's RGB-D sequences, of a wide lens and of a Kinect.
    EXPECT_EQ(problemOf(distorted(0.262383, -0.953104, -0.005358, 0.002628, 1.163314)), "");
    EXPECT_EQ(problemOf(distorted(0.231222, -0.784899, -0.003257, -0.000105, 0.917205)), "");
    EXPECT_EQ(problemOf(distorted(-0.35, 0.15)), "");
    EXPECT_EQ(problemOf(distorted(-0.2646, 0.8390, -0.0022, 0.0015, -1.0)), "");
}

TEST(CameraCheck, FocalLengthsMustBePossible)
{
    for (const double f : {0.0, -525.0, 1e-6, 1.0, 10.0, 1e5, 1e300, std::nan(""), HUGE_VAL}) {
        EXPECT_TRUE(isRefusedFor(camera(f, 525), "focal length")) << f;
        EXPECT_TRUE(isRefusedFor(camera(525, f), "focal length")) << f;
    }
    TCamera fisheye = camera(150, 150);
    fisheye.distortion = mrpt::img::DistortionModel::kannala_brandt;
    EXPECT_EQ(problemOf(fisheye), "") << "244 degrees wide";
    fisheye.setIntrinsicParamsFromValues(100, 100, 319.5, 239.5);
    EXPECT_TRUE(isRefusedFor(fisheye, "focal length")) << "367 degrees";
    TCamera empty;
    empty.ncols = empty.nrows = 0;
    EXPECT_NE(problemOf(empty), "");
}

TEST(CameraCheck, ThePrincipalPointMustBeInTheImage)
{
    EXPECT_TRUE(isRefusedFor(camera(525, 525, -1), "outside"));
    EXPECT_TRUE(isRefusedFor(camera(525, 525, 640), "outside"));
    EXPECT_TRUE(isRefusedFor(camera(525, 525, 319.5, 1e9), "outside"));
    EXPECT_TRUE(isRefusedFor(camera(525, 525, 319.5, std::nan("")), "outside"));
}

TEST(CameraCheck, DistortionMustBeUndoable)
{
    EXPECT_TRUE(isRefusedFor(distorted(std::nan("")), "no number"));
    EXPECT_TRUE(isRefusedFor(distorted(0, INFINITY), "no number"));
    for (const double k : {-50.0, -1e6, -1e300})
        EXPECT_TRUE(isRefusedFor(distorted(k), "cannot be undone")) << k;
    EXPECT_TRUE(isRefusedFor(distorted(0, 0, 1e6), "cannot be undone"));
}
