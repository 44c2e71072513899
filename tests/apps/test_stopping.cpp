// SPDX-License-Identifier: BSD-3-Clause
/** A program that the user stops keeps what it has, and says how to go on. */
#include "support/RunProgram.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
const std::string BIN = VOXELAND_TEST_BINARY_DIR "/bin/";

/** A rawlog that keeps rawlog2voxeland busy for a second or more. */
class Stopping : public ::testing::Test
{
 protected:
    void SetUp() override { writeRawlog(m_folder.file("in.rawlog"), smallFrames(120)); }

    /** Runs rawlog2voxeland, and stops it some time after it has begun to map.
     *  \param signals `kill` commands; $pid is the program */
    [[nodiscard]] ProgramResult stopped(const std::string& seconds,
                                        const std::string& signals) const
    {
        const std::string script =
            BIN +
            "rawlog2voxeland -i in.rawlog -o out.voxeland --export-dir exported --to 110 "
            "--timing 'the times.csv' --set map.resolution=0.02 & pid=$!\n"
            "until ls -l /proc/$pid/fd | grep -q in.rawlog || ! kill -0 $pid; do sleep 0.01; done\n"
            "sleep " +
            seconds + "; " + signals + "; wait $pid";
        return runProgramIn(m_folder.path().string(), "bash", {"-c", script});
    }

    TemporaryFolder m_folder;
};
}  // namespace

TEST_F(Stopping, TheCommandThatIsPrintedGoesOnToTheSameMap)
{
    ProgramResult first;
    for (const char* seconds : {"0.3", "1", "3"}) {
        first = stopped(seconds, "kill -INT $pid");
        if (first.errors.find("before a frame") == std::string::npos) break;
    }
    ASSERT_EQ(first.exitCode, 130) << first.errors;
    EXPECT_TRUE(fs::is_empty(m_folder.path() / "exported")) << "half a map is not exported";
    EXPECT_TRUE(fs::exists(m_folder.path() / "the times.csv"));

    const std::string before = "go on with:\n";
    const size_t at = first.errors.find(before);
    ASSERT_NE(at, std::string::npos) << first.errors;
    const std::string command = first.errors.substr(at + before.size());
    EXPECT_NE(command.find("--to 110"), std::string::npos) << command;
    const auto second = runProgramIn(m_folder.path().string(), "bash", {"-c", command});
    ASSERT_EQ(second.exitCode, 0) << second.errors;
    EXPECT_FALSE(fs::is_empty(m_folder.path() / "exported"));
    const auto whole = runProgramIn(
        m_folder.path().string(), "rawlog2voxeland",
        {"-i", "in.rawlog", "-o", "whole.voxeland", "--to", "110", "--set", "map.resolution=0.02"});
    ASSERT_EQ(whole.exitCode, 0) << whole.errors;
    EXPECT_EQ(readFile(m_folder.file("out.voxeland")), readFile(m_folder.file("whole.voxeland")));
}

TEST_F(Stopping, TerminationAndHangUpStopAsAnInterruptionDoes)
{
    for (const char* signal : {"TERM", "HUP"}) {
        const auto result = stopped("0.1", std::string("kill -") + signal + " $pid");
        EXPECT_EQ(result.exitCode, 130) << signal;
        EXPECT_NE(result.errors.find("rawlog2voxeland: interrupted"), std::string::npos)
            << result.errors;
    }
}

TEST_F(Stopping, TheSecondTimeEndsAtOnceAndLeavesNothing)
{
    const auto result = stopped("0.1", "while kill -INT $pid; do true; done 2>/dev/null");
    EXPECT_NE(result.exitCode, 0);
    EXPECT_EQ(result.errors.find("go on with"), std::string::npos) << result.errors;
    EXPECT_FALSE(fs::exists(m_folder.file("out.voxeland")));
}
