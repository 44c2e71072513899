// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/PoseTrack.h"
#include "voxeland/observations/RecordingClock.h"

#include <gtest/gtest.h>
#include <mrpt/system/datetime.h>

#include <cmath>

using namespace voxeland;
using mrpt::math::TPose3D;

namespace
{
mrpt::Clock::time_point at(double seconds)
{
    return mrpt::Clock::fromDouble(seconds);
}
}  // namespace

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

TEST(PoseTrack, SeveralPosesOfOneTimeAreToldApartByTheirOrder)
{
    PoseTrack track(0.25);
    EXPECT_TRUE(track.empty());
    EXPECT_TRUE(track.times().empty());
    for (const double x : {1, 2, 3}) track.add(at(4), {x, 0, 0, 0, 0, 0});
    track.add(at(6.5), {9, 0, 0, 0, 0, 0});
    EXPECT_EQ(track.recordedAt(at(4)), 3u);
    EXPECT_EQ(track.at(at(4))->x, 1);
    EXPECT_EQ(track.at(at(4), 1)->x, 2);
    EXPECT_EQ(track.at(at(4), 2)->x, 3);
    EXPECT_EQ(track.at(at(4), 7)->x, 3) << "the last";
    EXPECT_EQ(track.times().text(), "4.000 to 6.500 s");
    EXPECT_FALSE(track.at(INVALID_TIMESTAMP));
}

TEST(PoseTrack, TimesMayBeAsFarApartAsTheyCanBe)
{
    using Time = mrpt::Clock::time_point;
    EXPECT_EQ(secondsBetween(Time::min(), Time::max()), std::pow(2, 64) * 1e-7);
    EXPECT_EQ(secondsBetween(at(1), at(3)), 2);
    PoseTrack track(1);
    track.add(Time::min(), {1, 0, 0, 0, 0, 0});
    track.add(Time::max(), {2, 0, 0, 0, 0, 0});
    EXPECT_FALSE(track.at(at(5)));
    EXPECT_EQ(track.at(Time::max())->x, 2);
    RecordingClock clock;
    using Stream = RecordingClock::Stream;
    for (const Time& time : {Time::max(), Time::max()}) clock.recordingOf(Stream::scans, time);
    EXPECT_EQ(clock.recordingOf(Stream::scans, Time::min()), 1U);
}
