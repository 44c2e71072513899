// SPDX-License-Identifier: BSD-3-Clause
#include "observations/Trajectory.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

using namespace voxeland;
using voxeland::test::TemporaryFolder;

namespace
{
mrpt::Clock::time_point at(double seconds)
{
    return mrpt::Clock::fromDouble(seconds);
}

Trajectory read(const std::string& text, bool strict = false)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("track.tum"), text);
    return Trajectory::fromTumFile(folder.file("track.tum"), 1, strict);
}

/** The message with which a trajectory is refused. */
std::string refusal(const std::string& text, bool strict = false)
{
    try {
        read(text, strict);
    } catch (const InputError& e) {
        EXPECT_LT(std::string(e.what()).size(), 300u);
        return e.what();
    }
    return "accepted";
}
}  // namespace

TEST(Trajectory, ReadsTumFiles)
{
    // A quarter turn to the left about z: (0, 0, sin 45, cos 45).
    const auto track = read(
                           "# timestamp tx ty tz qx qy qz qw\n"
                           "\n"
                           "1311868164.25 1 -2 0.5 0 0 0.70710678 0.70710678\r\n"
                           "1311868164.50 1 -2 0.5 0 0 0 -1\n")
                           .poses;
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

/** Two poses, at 10 s and 11 s, 1 m and 2 m along x. */
TEST(Trajectory, MayBeWrittenInManyWays)
{
    for (const char* text :
         {"10 1 0 0 0 0 0 1\n11 2 0 0 0 0 0 1\n",
          "\xEF\xBB\xBF"
          "10 1 0 0 0 0 0 1\n11 2 0 0 0 0 0 1",
          "  # t x\r\n\r\n10\t1 0 0  0 0 0 1 \r\n 11 2 0 0 0 0 0 1\r\n",
          "timestamp tx ty tz qx qy qz qw\n10 1 0 0 0 0 0 1\n11 2 0 0 0 0 0 1\n",
          "10,1,0,0,0,0,0,1\n11,2,0,0,0,0,0,1\n",
          "10, 1, 0, 0, 0, 0, 0, 1\n11, 2, 0, 0, 0, 0, 0, 1\n",
          "10;1;0;0;0;0;0;1\n11;2;0;0;0;0;0;1\n", "11 2 0 0 0 0 0 1\n10 1 0 0 0 0 0 1\n",
          "10 1 0 0 0 0 0 1 0.5\n11 2e0 0 0 0 0 0 +1 0.5\n"})
    {
        const Trajectory trajectory = read(text, true);
        EXPECT_EQ(trajectory.poses.times().text(), "10.000 to 11.000 s") << text;
        EXPECT_NEAR(trajectory.poses.at(at(10.25))->x, 1.25, 1e-6) << text;
        EXPECT_TRUE(trajectory.notes.empty()) << text;
    }
}

TEST(Trajectory, TimesTooGreatForSecondsAreOfAFinerUnit)
{
    const std::string pose = " 1 0 0 0 0 0 1\n";
    for (const char* zeros : {"000", "000000", "000000000"}) {
        const Trajectory trajectory =
            read("1305031100" + std::string(zeros) + pose + "1305031101" + zeros + pose);
        EXPECT_EQ(trajectory.poses.times().text(), "1305031100.000 to 1305031101.000 s");
        ASSERT_EQ(trajectory.notes.size(), 1u);
        EXPECT_NE(trajectory.notes[0].find("seconds"), std::string::npos);
    }
    EXPECT_EQ(read("1305031100" + pose).poses.times().first, 1305031100);
}

TEST(Trajectory, OddLinesAreLeftOutCountedAndTheFirstIsNamed)
{
    const std::string good = "1 0 0 0 0 0 0 1\n";
    for (const char* line :
         {"2 0 0 0 0 0 0\n", "2 0 zero 0 0 0 0 1\n", "2 0 0 0 0 0 0 0\n", "2 0 0 0 1 1 1 1\n",
          "2 nan 0 0 0 0 0 1\n", "2 0 0 0 0 0 0 NaN\n", "nan 0 0 0 0 0 0 1\n", "2\n",
          "2 inf 0 0 0 0 0 1\n", "2 1e9 0 0 0 0 0 1\n", "2,0,0,0,1,0,0,0,0,0,0,0\n"})
    {
        const Trajectory trajectory = read(good + line + line);
        EXPECT_EQ(trajectory.leftOut.count(), 2u) << line;
        EXPECT_EQ(trajectory.poses.times().text(), "1.000 to 1.000 s") << line;
        ASSERT_EQ(trajectory.notes.size(), 1u);
        EXPECT_NE(trajectory.notes[0].find("line 2"), std::string::npos) << trajectory.notes[0];
        EXPECT_NE(trajectory.notes[0].find("track.tum"), std::string::npos);
        EXPECT_NE(refusal(good + line, true).find("line 2"), std::string::npos) << line;
        EXPECT_NE(refusal(line).find("line 1"), std::string::npos) << "nothing is left of " << line;
    }
    EXPECT_NE(refusal("# nothing\n").find("no pose"), std::string::npos);
    EXPECT_THROW(Trajectory::fromTumFile("/no/such/file.tum", 1), InputError);
}

/** At (1, 2, 3), turned by 90 degrees about z: q = (0, 0, sqrt(1/2), sqrt(1/2)). */
TEST(Trajectory, ColumnsAreThoseThatTheirTitlesSay)
{
    const std::string half = "0.70710678";
    const std::string places = "1,2,3,", turnFirst = half + ",0,0," + half;
    for (const std::string& text : {
             "1 1 2 3 0 0 " + half + " " + half,
             "# timestamp tx ty tz qx qy qz qw\n1 1 2 3 0 0 " + half + " " + half,
             "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y "
             "[], "
             "q_RS_z [], v_RS_R_x [m s^-1], b_w_RS_S_x [rad s^-1]\n1," +
                 places + turnFirst + ",9,9",
             "time,qw,qx,qy,qz,x,y,z\n1," + turnFirst + ",1,2,3",
             "%time,field.header.seq,field.pose.position.x,field.pose.position.y,"
             "field.pose.position.z,field.pose.orientation.x,field.pose.orientation.y,"
             "field.pose.orientation.z,field.pose.orientation.w\n1,7," +
                 places + "0,0," + half + "," + half,
         })
    {
        const auto pose = read(text + "\n").poses.at(mrpt::Clock::fromDouble(1));
        ASSERT_TRUE(pose) << text;
        EXPECT_NEAR(pose->x, 1, 1e-6) << text;
        EXPECT_NEAR(pose->y, 2, 1e-6) << text;
        EXPECT_NEAR(pose->z, 3, 1e-6) << text;
        EXPECT_NEAR(pose->yaw, M_PI / 2, 1e-6) << text;
        EXPECT_NEAR(pose->pitch, 0, 1e-6) << text;
        EXPECT_NEAR(pose->roll, 0, 1e-6) << text;
    }
    EXPECT_EQ(read("# made by a program\n1 1 2 3 0 0 0 1\n").notes.size(), 0U);
    EXPECT_EQ(read("t,qw,qx,qy,qz,x,y,z\n1,1,0,0,0,1,2,3\n").notes.size(), 1U);
}

TEST(Trajectory, DecimalCommasAreRefusedByName)
{
    for (const char* line :
         {"1305031100,5 0 0 0 0 0 0 1\n", "1305031100 0,25 1 2 0 0 0 1\n", "1;0,5;0;0;0;0;0;1\n"})
        EXPECT_NE(refusal("# t\n" + std::string(line)).find("line 2"), std::string::npos) << line;
    EXPECT_NE(refusal("1 0,5 0 0 0 0 0 1\n").find("decimal comma"), std::string::npos);
}
