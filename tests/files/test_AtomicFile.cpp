// SPDX-License-Identifier: BSD-3-Clause
#include "files/OutputPart.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <functional>
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
    fs::create_directory(folder.file("there"));
    test::writeFile(folder.file("there/real"), "old");
    fs::create_symlink("there/real", folder.file("link"));
    fs::create_symlink("there/new", folder.file("dangling"));
    fs::create_symlink("dangling", folder.file("to_it"));
    for (const std::string& name : {folder.file("link"), folder.file("to_it")}) {
        checkWritable(name);
        writeText(name, "new");
        EXPECT_TRUE(fs::is_symlink(name)) << name;
        EXPECT_EQ(test::readFile(name), "new");
    }
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.file("there/new"))));
    EXPECT_EQ(filesIn(folder.file("there")), 2U);
}

TEST(AtomicFile, aLinkInVainIsNoticedBeforeTheWork)
{
    const TemporaryFolder folder;
    fs::create_symlink("absent/a", folder.file("link"));
    fs::create_symlink("loop", folder.file("loop"));
    EXPECT_EQ(complaint(folder.file("link")), "cannot write " + folder.file("link") +
                                                  ": there is no folder " + folder.file("absent") +
                                                  ": create it first");
    EXPECT_THROW(checkWritable(folder.file("loop")), OutputError);
    EXPECT_TRUE(fs::is_symlink(folder.file("link")) && fs::is_symlink(folder.file("loop")));
}

TEST(AtomicFile, aDeviceIsWrittenThroughALink)
{
    const TemporaryFolder folder;
    fs::create_symlink("/dev/full", folder.file("full"));
    EXPECT_NE(complaint(folder.file("full")).find("No space left on device"), std::string::npos);
    EXPECT_TRUE(fs::is_symlink(folder.file("full")));
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

namespace
{
/** Runs something in a process of its own, whose standard output is a descriptor or closed (-1).
 *  \return its exit code: 0 if nothing was thrown */
int withStandardOutput(int descriptor, const std::function<void()>& action)
{
    const pid_t child = fork();
    if (child == 0) {
        if (descriptor < 0)
            close(STDOUT_FILENO);
        else
            dup2(descriptor, STDOUT_FILENO);
        try {
            action();
        } catch (const OutputError&) {
            _exit(5);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
}  // namespace

TEST(AtomicFile, standardOutputIsWrittenWhateverItIs)
{
    const TemporaryFolder folder;
    const std::string link = folder.file("stdout");
    fs::create_symlink("/proc/self/fd/1", link);
    const auto write = [&] { writeText(link, "text"); };

    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    EXPECT_EQ(withStandardOutput(ends[1], write), 0);
    char got[5] = "";
    EXPECT_EQ(read(ends[0], got, sizeof(got)), 4);
    EXPECT_STREQ(got, "text");
    close(ends[0]);
    close(ends[1]);

    EXPECT_EQ(withStandardOutput(-1, write), 5);
    EXPECT_TRUE(fs::is_symlink(link)) << "nothing takes the place of what is closed";
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, unfinishedPartsCanBeRemovedAtOnce)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("old"), "old");
    const int exitCode = withStandardOutput(STDERR_FILENO, [&] {
        AtomicFile finished(folder.file("finished"));
        test::writeFile(finished.part(), "whole");
        finished.commit();
        const AtomicFile unasked(folder.file("unasked"));
        AtomicFile file(folder.file("old"));
        test::writeFile(file.part(), "half");
        OutputPart tree(folder.file("tree"), OutputPart::Kind::folder);
        fs::create_directories(tree.path() + "/a/b");
        fs::create_symlink(folder.path(), tree.path() + "/a/link");
        for (int i = 0; i < 500; ++i)
            test::writeFile(tree.path() + "/a/" + std::to_string(i) + std::string(100, 'n'), "");
        removeUnfinishedParts();
        _exit(filesIn(folder.path()) == 2 ? 0 : 1);
    });
    EXPECT_EQ(exitCode, 0);
    EXPECT_EQ(test::readFile(folder.file("finished")), "whole");
    EXPECT_EQ(test::readFile(folder.file("old")), "old");
}

TEST(AtomicFile, partsOfTheParentAreNotThoseOfAChild)
{
    const TemporaryFolder folder;
    AtomicFile file(folder.file("a"));
    test::writeFile(file.part(), "half");
    EXPECT_EQ(withStandardOutput(STDERR_FILENO, [] { removeUnfinishedParts(); }), 0);
    EXPECT_TRUE(fs::exists(file.part()));
}
