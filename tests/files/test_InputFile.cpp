// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/InputFile.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

using namespace voxeland;

namespace
{
std::string errorOf(const std::string& file)
{
    try {
        checkInputFile(file, "the model");
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}
}  // namespace

TEST(InputFile, tellsTheSizeOfAFileAndOfWhatALinkPointsTo)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("a"), "12345");
    std::filesystem::create_symlink("a", folder.path() / "link");
    EXPECT_EQ(checkInputFile(folder.file("a"), ""), 5U);
    EXPECT_EQ(checkInputFile(folder.file("link"), ""), 5U);
}

TEST(InputFile, whatIsNoRegularFileIsRefusedAtOnce)
{
    const test::TemporaryFolder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::string noFile = ": it is a pipe or a device: write its content to a file first";
    EXPECT_EQ(errorOf(pipe), "cannot read the model " + pipe + noFile);
    EXPECT_EQ(errorOf("/dev/zero"), "cannot read the model /dev/zero" + noFile);
    EXPECT_EQ(errorOf(folder.path().string()),
              "cannot read the model " + folder.path().string() + ": it is a folder: name a file");
    EXPECT_EQ(errorOf(folder.file("none")),
              "cannot read the model " + folder.file("none") + ": there is no such file");
    const std::string madeUp = ": it is made up by the system: write its content to a file first";
    std::filesystem::create_symlink("/proc/self/status", folder.path() / "link");
    for (const std::string& file :
         {std::string("/proc/version"), std::string("/proc/self/mem"), folder.file("link")})
        EXPECT_EQ(errorOf(file), "cannot read the model " + file + madeUp);
    EXPECT_NE(errorOf(std::string(5000, 'a')).find(": correct its path"), std::string::npos);
}
