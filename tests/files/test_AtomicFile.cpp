// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace
{
size_t filesIn(const fs::path& folder)
{
    return static_cast<size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void writeText(const std::string& file, const std::string& text)
{
    writeAtomically(file, [&](std::ostream& out) { out << text; });
}

/** What an attempt to write says. */
std::string complaint(const std::string& file)
{
    try {
        writeText(file, "new");
    } catch (const OutputError& e) {
        return e.what();
    }
    return "";
}
}  // namespace

TEST(AtomicFile, writesEveryByteAndNothingElse)
{
    const TemporaryFolder folder;
    const std::string text("a\0b\r\n", 5);
    writeText(folder.file("a"), text);
    EXPECT_EQ(test::readFile(folder.file("a")), text);
    writeText(folder.file("a"), "shorter");
    EXPECT_EQ(test::readFile(folder.file("a")), "shorter");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, checkingBeforeTheWorkChangesNothing)
{
    const TemporaryFolder folder;
    checkWritable(folder.file("new"));
    EXPECT_EQ(filesIn(folder.path()), 0U);
    writeText(folder.file("a"), "old");
    checkWritable(folder.file("a"));
    EXPECT_EQ(test::readFile(folder.file("a")), "old");
    EXPECT_EQ(filesIn(folder.path()), 1U);
    for (const char* file : {"", "/proc"}) EXPECT_THROW(checkWritable(file), OutputError) << file;
    EXPECT_THROW(checkWritable(folder.file("missing/a")), OutputError);
    EXPECT_NO_THROW(checkWritable("/dev/full")) << "a device tells only when it is written";
}

TEST(AtomicFile, aFolderThatThisUserMayNotWriteToIsNoticedBeforeTheWork)
{
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_write, fs::perm_options::remove);
    if (access(folder.path().c_str(), W_OK) == 0) GTEST_SKIP() << "root may write anywhere";
    EXPECT_THROW(checkWritable(folder.file("a")), OutputError);
    fs::permissions(folder.path(), fs::perms::owner_write, fs::perm_options::add);
}

TEST(AtomicFile, twoWritersOfOneFileDoNotMeet)
{
    const TemporaryFolder folder;
    AtomicFile first(folder.file("a"));
    test::writeFile(first.part(), "first");
    writeText(folder.file("a"), "second");
    EXPECT_EQ(test::readFile(folder.file("a")), "second");
    EXPECT_EQ(test::readFile(first.part()), "first");
    first.commit();
    EXPECT_EQ(test::readFile(folder.file("a")), "first");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, whatAKilledWriterLeftIsRemovedByTheNext)
{
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        AtomicFile file(folder.file("a"));
        test::writeFile(file.part(), "half");
        kill(getpid(), SIGKILL);
    }
    waitpid(child, nullptr, 0);
    ASSERT_EQ(filesIn(folder.path()), 1U);
    test::writeFile(folder.file("a.notes.part"), "of somebody else");
    test::writeFile(folder.file("a.download.part"), "of a browser");
    test::writeFile(folder.file("a.part"), "of an earlier version, or of a browser");
    checkWritable(folder.file("a"));
    EXPECT_EQ(filesIn(folder.path()), 4U) << "checking touches nothing";
    writeText(folder.file("a"), "whole");
    EXPECT_EQ(filesIn(folder.path()), 4U);
    EXPECT_EQ(test::readFile(folder.file("a")), "whole");
    EXPECT_EQ(test::readFile(folder.file("a.notes.part")), "of somebody else");
    EXPECT_EQ(test::readFile(folder.file("a.download.part")), "of a browser");
    EXPECT_TRUE(std::filesystem::exists(folder.file("a.part")));
}

TEST(AtomicFile, othersMayReadWhatIsWritten)
{
    const TemporaryFolder folder;
    const mode_t before = umask(022);
    writeText(folder.file("a"), "text");
    umask(before);
    EXPECT_EQ(fs::status(folder.file("a")).permissions(), static_cast<fs::perms>(0644));
}

TEST(AtomicFile, aWriterThatThrowsLeavesTheOldFile)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("a"), "old");
    const auto failing = [](std::ostream& out) {
        out << "half of the";
        throw std::logic_error("bang");
    };
    EXPECT_THROW(writeAtomically(folder.file("a"), failing), std::logic_error);
    EXPECT_EQ(test::readFile(folder.file("a")), "old");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, withoutCommitNothingStays)
{
    const TemporaryFolder folder;
    {
        AtomicFile file(folder.file("a"));
        EXPECT_EQ(fs::path(file.part()).parent_path(), fs::canonical(folder.path()));
        test::writeFile(file.part(), "text");
    }
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(AtomicFile, saysWhatIsWrongAndWhatToDo)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("file"), "");
    EXPECT_EQ(complaint(folder.path().string()),
              "cannot write " + folder.path().string() + ": it is a folder: name a file in it");
    for (const char* parent : {"absent", "file"})
        EXPECT_EQ(complaint(folder.file(parent) + "/a"),
                  "cannot write " + folder.file(parent) + "/a: there is no folder " +
                      folder.file(parent) + ": create it first");
    EXPECT_NE(complaint(""), "");
}

TEST(AtomicFile, noticesAFullDisk)
{
    EXPECT_EQ(complaint("/dev/full"),
              "cannot write /dev/full: No space left on device: free some space or choose another "
              "place");
    EXPECT_FALSE(fs::is_regular_file("/dev/full")) << "a device must not be replaced";
}

TEST(AtomicFile, aLinkStaysALink)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("real"), "old");
    fs::create_symlink(folder.file("real"), folder.file("link"));
    writeText(folder.file("link"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));
    EXPECT_EQ(test::readFile(folder.file("real")), "new");
}
