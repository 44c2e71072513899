// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/errors.h"
#include "voxeland/observations/PoseTrack.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace voxeland;
using mrpt::math::TPose3D;
using voxeland::test::TemporaryFolder;

namespace
{
mrpt::Clock::time_point at(double seconds)
{
    return mrpt::Clock::fromDouble(seconds);
}

PoseTrack trackOf(const std::string& text, double maxGap = 1)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("track.tum"), text);
    return PoseTrack::fromTumFile(folder.file("track.tum"), maxGap);
}

/** The message with which a trajectory is refused. */
std::string refusal(const std::string& text)
{
    try {
        trackOf(text);
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}
}  // namespace

TEST(PoseTrack, ReadsTumFiles)
{
    // A quarter turn to the left about z: (0, 0, sin 45, cos 45).
    const auto track = trackOf(
        "# timestamp tx ty tz qx qy qz qw\n"
        "\n"
        "1311868164.25 1 -2 0.5 0 0 0.70710678 0.70710678\r\n"
        "1311868164.50 1 -2 0.5 0 0 0 -1\n");
    const auto pose = track.at(at(1311868164.25));
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->x, 1, 1e-12);
    EXPECT_NEAR(pose->y, -2, 1e-12);
    EXPECT_NEAR(pose->z, 0.5, 1e-12);
    EXPECT_NEAR(pose->yaw, M_PI / 2, 1e-7);
    EXPECT_NEAR(pose->pitch, 0, 1e-7);
    EXPECT_NEAR(pose->roll, 0, 1e-7);
    EXPECT_NEAR(track.at(at(1311868164.50))->yaw, 0, 1e-9);
}

TEST(PoseTrack, InterpolatesAlongTheShortestArc)
{
    PoseTrack track(1);
    track.add(at(10), {0, 0, 0, 0, 0, 0});
    track.add(at(11), {1, 2, -4, M_PI / 2, 0, 0});
    const auto quarter = track.at(at(10.25));
    ASSERT_TRUE(quarter);
    EXPECT_NEAR(quarter->x, 0.25, 1e-6);
    EXPECT_NEAR(quarter->y, 0.5, 1e-6);
    EXPECT_NEAR(quarter->z, -1, 1e-6);
    EXPECT_NEAR(quarter->yaw, M_PI / 8, 1e-6);

    PoseTrack overTheBack(1);
    overTheBack.add(at(0), {0, 0, 0, M_PI - 0.1, 0, 0});
    overTheBack.add(at(1), {0, 0, 0, -M_PI + 0.1, 0, 0});
    EXPECT_NEAR(std::cos(overTheBack.at(at(0.5))->yaw), -1, 1e-6);
}

TEST(PoseTrack, DoesNotInterpolateOverGapsNorBeyondItsEnds)
{
    PoseTrack track(0.25);
    track.add(at(1), {1, 0, 0, 0, 0, 0});
    track.add(at(1.2), {2, 0, 0, 0, 0, 0});
    track.add(at(2), {3, 0, 0, 0, 0, 0});
    EXPECT_TRUE(track.at(at(1.1)));
    EXPECT_FALSE(track.at(at(1.5)));
    EXPECT_FALSE(track.at(at(0.99)));
    EXPECT_FALSE(track.at(at(2.01)));
    EXPECT_FALSE(PoseTrack(1).at(at(1)));
}

TEST(PoseTrack, WithinAMillisecondThePoseIsTheRecordedOne)
{
    PoseTrack track(0.25);
    track.add(at(1), {1, 0, 0, 0, 0, 0});
    track.add(at(1.1), {2, 0, 0, 0, 0, 0});
    EXPECT_EQ(track.at(at(1.0009))->x, 1);
    EXPECT_EQ(track.at(at(1.0992))->x, 2);
    EXPECT_EQ(track.at(at(0.9992))->x, 1);
    EXPECT_EQ(track.at(at(1.1009))->x, 2);
    EXPECT_NEAR(track.at(at(1.002))->x, 1.02, 1e-4);
}

TEST(PoseTrack, CovariancesAreInterpolatedAsThePosesAre)
{
    const auto covariance = [](double value) {
        auto matrix = std::make_shared<mrpt::math::CMatrixDouble66>();
        matrix->fill(value);
        return matrix;
    };
    PoseTrack track(1);
    track.add(at(0), {}, covariance(4));
    track.add(at(1), {}, covariance(8));
    track.add(at(2), {});
    track.add(at(3), {});
    EXPECT_NEAR((*track.covarianceAt(at(0)))(2, 3), 4, 1e-12);
    EXPECT_NEAR((*track.covarianceAt(at(0.25)))(2, 3), 5, 1e-12);
    EXPECT_NEAR((*track.covarianceAt(at(1.75)))(5, 0), 2, 1e-12) << "none counts as exact";
    EXPECT_EQ(track.covarianceAt(at(2)), nullptr);
    EXPECT_EQ(track.covarianceAt(at(2.5)), nullptr);
    EXPECT_EQ(track.covarianceAt(at(7)), nullptr) << "there is no pose either";
}

TEST(PoseTrack, ForgettingKeepsWhatLaterTimesNeed)
{
    PoseTrack track(1);
    for (int i = 0; i < 10; ++i) track.add(at(i), {static_cast<double>(i), 0, 0, 0, 0, 0});
    track.forgetBefore(at(5.5));
    EXPECT_NEAR(track.at(at(5.5))->x, 5.5, 1e-6);
    EXPECT_FALSE(track.at(at(4.5)));
    track.forgetBefore(at(100));
    EXPECT_EQ(track.at(at(9))->x, 9);
}

TEST(PoseTrack, MalformedFilesAreRefusedWithFileAndLine)
{
    const std::string good = "1 0 0 0 0 0 0 1\n";
    EXPECT_EQ(refusal(good), "accepted");
    for (const char* line :
         {"2 0 0 0 0 0 0\n", "2 0 zero 0 0 0 0 1\n", "2 0 0 0 0 0 0 0\n", "2 0 0 0 1 1 1 1\n",
          "2 nan 0 0 0 0 0 1\n", "2 0 0 0 0 0 0 nan\n", "2,0,0,0,0,0,0,1\n"})
    {
        const std::string message = refusal(good + line);
        EXPECT_NE(message.find("line 2"), std::string::npos) << line << message;
        EXPECT_NE(message.find("track.tum"), std::string::npos) << line << message;
    }
    EXPECT_NE(refusal("# nothing\n").find("no pose"), std::string::npos);
    EXPECT_THROW(PoseTrack::fromTumFile("/no/such/file.tum", 1), InputError);
}
