// SPDX-License-Identifier: BSD-3-Clause
/** Outputs that are links or streams, and what is left of them where a run ends before its time. */
#include "support/RunProgram.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <set>

using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
class OutputsOfPrograms : public testing::Test
{
 protected:
    void SetUp() override
    {
        writeRawlog(file("in.rawlog"), smallFrames(3), true);
        ASSERT_EQ(shell("rawlog2voxeland --quiet -i in.rawlog -o in.voxeland").exitCode, 0);
    }

    [[nodiscard]] std::string file(const std::string& name) const { return m_folder.file(name); }
    /** Runs commands, which find our programs, in the folder. */
    [[nodiscard]] ProgramResult shell(const std::string& commands) const
    {
        return runProgramIn(
            m_folder.path().string(), "bash",
            {"-c", "set -o pipefail; PATH=" VOXELAND_TEST_BINARY_DIR "/bin:$PATH\n" + commands});
    }
    /** Runs a program, kills it when its rawlog is being written, and waits for its end. */
    [[nodiscard]] ProgramResult killed(const std::string& program, const std::string& signal) const
    {
        return shell(program +
                     " & pid=$!\nuntil ls -d *.part >parts 2>/dev/null || ! kill -0 $pid; do "
                     "sleep 0.02; done\nrm parts; kill -" +
                     signal + " $pid; wait $pid");
    }
    [[nodiscard]] std::set<std::string> names() const
    {
        std::set<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(m_folder.path()))
            found.insert(entry.path().lexically_relative(m_folder.path()));
        return found;
    }

    TemporaryFolder m_folder;
};

const std::string SIMULATE =
    "voxeland-simulate --quiet --rooms 1 --width 64 --height 48 -o s.rawlog";
}  // namespace

TEST_F(OutputsOfPrograms, standardOutputMayBeAPipe)
{
    fs::create_symlink("/proc/self/fd/1", file("link.ply"));  // as /dev/stdout is
    const auto shown = shell("voxeland-export -m in.voxeland --ply link.ply | cat");
    EXPECT_EQ(shown.exitCode, 0) << shown.errors;
    EXPECT_EQ(shown.output.substr(0, 4), "ply\n");
    EXPECT_TRUE(fs::is_symlink(file("link.ply")));
}

TEST_F(OutputsOfPrograms, closedStreamsAreTakenByNoFile)
{
    fs::create_symlink("/proc/self/fd/1", file("link.ply"));
    const auto before = names();
    for (const char* command : {"rawlog2voxeland --quiet -i in.rawlog -o out.voxeland >&-",
                                "voxeland-export -m in.voxeland --ply link.ply >&-"})
    {
        const auto result = shell(command);
        EXPECT_EQ(result.exitCode, 5) << command;
        EXPECT_NE(result.errors.find("standard output: it is closed"), std::string::npos)
            << result.errors;
        EXPECT_EQ(names(), before) << "an output was left";
    }
    EXPECT_TRUE(fs::is_symlink(file("link.ply")));
    EXPECT_EQ(shell("rawlog2voxeland -i in.rawlog -o out.voxeland <&- 2>&-").exitCode, 0);
    EXPECT_EQ(readFile(file("out.voxeland")), readFile(file("in.voxeland")));
}

TEST_F(OutputsOfPrograms, aLimitOfSizeIsAnErrorOfWriting)
{
    const auto before = names();
    for (const std::string& command :
         {std::string("rawlog2voxeland --quiet -i in.rawlog -o out.voxeland"),
          std::string("voxeland-export -m in.voxeland --ply out.ply"), SIMULATE})
    {
        const auto result = shell("ulimit -f 1; " + command);
        EXPECT_EQ(result.exitCode, 5) << command << ": " << result.errors;
        EXPECT_NE(result.errors.find("ulimit"), std::string::npos) << result.errors;
        EXPECT_EQ(names(), before) << command;
    }
}

TEST_F(OutputsOfPrograms, whatIsEndedByASignalLeavesNothing)
{
    const auto before = names();
    for (const auto& [signal, number] :
         {std::pair("INT", 2), std::pair("TERM", 15), std::pair("HUP", 1)})
    {
        EXPECT_EQ(killed(SIMULATE + " --frames 5000", signal).exitCode, 128 + number) << signal;
        EXPECT_EQ(names(), before) << signal;
    }
    EXPECT_EQ(killed("nohup " + SIMULATE + " --frames 40", "HUP").exitCode, 0);
    EXPECT_TRUE(fs::exists(file("s.rawlog")));
}

TEST_F(OutputsOfPrograms, aRawlogThatIsALinkStaysOne)
{
    fs::create_directory(file("real"));
    writeFile(file("real/old.rawlog"), "old");
    fs::create_symlink("real/old.rawlog", file("s.rawlog"));
    for (int run = 0; run < 2; ++run) {
        const auto result = shell(SIMULATE + " --frames 2");
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        ASSERT_TRUE(fs::is_symlink(file("s.rawlog")));
        const auto mapped = shell("rawlog2voxeland --quiet -i s.rawlog -o s.voxeland");
        EXPECT_EQ(mapped.exitCode, 0) << mapped.errors;
        EXPECT_TRUE(fs::is_directory(file("s_Images"))) << "where readers of s.rawlog look";
        // The second time, the link points to nothing.
        fs::remove(file("real/old.rawlog"));
        fs::remove_all(file("s_Images"));
    }
}

TEST_F(OutputsOfPrograms, aRawlogIsNoDevice)
{
    for (const char* device : {"/dev/null", "/dev/full", "/proc/self/fd/1"}) {
        fs::create_symlink(device, file("s.rawlog"));
        const auto before = names();
        const auto result = shell(SIMULATE + " --frames 2 | cat");
        EXPECT_EQ(result.exitCode, 5) << result.errors;
        EXPECT_NE(result.errors.find("it is a device"), std::string::npos) << result.errors;
        EXPECT_EQ(names(), before);
        EXPECT_TRUE(fs::is_symlink(file("s.rawlog")));
        fs::remove(file("s.rawlog"));
    }
}

TEST_F(OutputsOfPrograms, noPartOfAnInputRawlogIsReplaced)
{
    ASSERT_EQ(shell(SIMULATE + " --frames 2").exitCode, 0);
    writeFile(file("coco.json"), "[]");
    const auto before = names();
    const std::string sidecar = readFile(file("s.instances.rawlog"));
    const std::string picture = fs::directory_iterator(file("s_Images"))->path().filename();
    for (const std::string& command :
         {std::string("rawlog-add-instances -i s.rawlog --coco coco.json -o s.instances.rawlog"),
          std::string("rawlog-add-instances -i s.instances.rawlog --coco coco.json -o s.rawlog"),
          std::string("rawlog-add-instances -i s.rawlog --coco coco.json -o s_Images/new.rawlog"),
          std::string("rawlog2voxeland -i s.rawlog -o s.instances.rawlog"),
          std::string("rawlog2voxeland -i s.rawlog -o o.voxeland --trace s_Images/") + picture,
          std::string("rawlog2voxeland -i s.rawlog -o o.voxeland --export-dir s_Images"),
          std::string("rgbd2rawlog --format 7scenes -i s_Images -o s.rawlog"),
          SIMULATE + " --gt s_Images"})
    {
        const auto result = shell(command);
        EXPECT_EQ(result.exitCode, 1) << command << ": " << result.errors;
        EXPECT_NE(result.errors.find("would replace an input"), std::string::npos) << result.errors;
        EXPECT_EQ(names(), before) << command;
    }
    EXPECT_EQ(readFile(file("s.instances.rawlog")), sidecar);
    for (int run = 0; run < 2; ++run) {  // the second time, its images are a link
        const auto copied = shell("rawlog-add-instances -i s.rawlog --coco coco.json -o t.rawlog");
        EXPECT_EQ(copied.exitCode, 0) << copied.errors;
    }
    EXPECT_EQ(shell("rawlog-add-instances -i t.rawlog --coco coco.json -o s.rawlog").exitCode, 1)
        << "the images of s.rawlog are those of t.rawlog";
}
