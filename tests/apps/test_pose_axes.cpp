// SPDX-License-Identifier: BSD-3-Clause
/** Trajectories of the robot, of a camera, and taken for the wrong one. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

using namespace voxeland::test;

TEST(PoseAxes, PosesThatDoNotFitAreToldAndOthersAreNot)
{
    const TemporaryFolder folder;
    const std::string rawlog = folder.file("s.rawlog"), map = folder.file("s.voxeland");
    const auto made = runProgram(
        "voxeland-simulate", {"-o", rawlog, "--gt", folder.file("truth"), "--rooms", "1",
                              "--frames", "40", "--width", "160", "--height", "120", "--quiet"});
    ASSERT_EQ(made.exitCode, 0) << made.errors;
    const auto warnings = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"-i", rawlog, "-o", map, "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto mapped = runProgram("rawlog2voxeland", arguments);
        EXPECT_EQ(mapped.exitCode, 0) << mapped.errors;
        return mapped.errors;
    };
    const std::string trajectory = folder.file("truth/trajectory.tum");
    EXPECT_EQ(warnings({}), "");
    EXPECT_EQ(warnings({"--every", "8"}), "");
    EXPECT_EQ(warnings({"--poses", trajectory}), "");
    for (const char* wrong : {"optical", "opengl"})
        EXPECT_NE(
            warnings({"--poses", trajectory, "--pose-axes", wrong}).find("the poses do not fit"),
            std::string::npos)
            << wrong;
}
