// SPDX-License-Identifier: BSD-3-Clause
#include "files/NamedFile.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
/** folder/in.png, out.png beside the folder, and links. */
class NamedFile : public testing::Test
{
 protected:
    NamedFile()
    {
        fs::create_directories(folder() / "sub");
        test::writeFile(folder() / "in.png", "in");
        test::writeFile(m_root.file("out.png"), "out");
        fs::create_directory(m_root.file("folder2"));
        test::writeFile(m_root.file("folder2/out.png"), "out");
        fs::create_symlink(m_root.file("out.png"), folder() / "away.png");
        fs::create_symlink(m_root.file("folder2"), folder() / "away");
        fs::create_symlink("../in.png", folder() / "sub" / "back.png");
        fs::create_symlink(folder(), m_root.file("link"));
        fs::create_symlink("loop", folder() / "loop");
    }
    [[nodiscard]] fs::path folder() const { return m_root.path() / "folder"; }

    [[nodiscard]] bool isTaken(const std::string& name, Links links) const
    {
        return isTaken(folder(), name, links);
    }
    [[nodiscard]] static bool isTaken(const fs::path& from, const std::string& name, Links links)
    {
        try {
            return namedFile(from, name, "list.txt", links, false) == from / name;
        } catch (const InputError&) {
            return false;
        }
    }

    test::TemporaryFolder m_root;
};
}  // namespace

TEST_F(NamedFile, LiesInTheFolder)
{
    for (const Links links : {Links::followed, Links::staysInside}) {
        for (const std::string name :
             {"in.png", "./in.png", "sub/new.png", "sub/back.png", "..png"})
            EXPECT_TRUE(isTaken(name, links)) << name;
        EXPECT_TRUE(isTaken((folder() / "in.png").string(), links));
        EXPECT_TRUE(isTaken(folder().string() + "/", "in.png", links));
        EXPECT_TRUE(isTaken(m_root.file("link"), "in.png", links)) << "the folder may be a link";
        for (const std::string name :
             {"../out.png", "sub/../../out.png", "/etc/passwd", "..", "../folder2/out.png"})
            EXPECT_FALSE(isTaken(name, links)) << name;
        EXPECT_FALSE(isTaken(m_root.file("out.png"), links));
        EXPECT_FALSE(isTaken(m_root.file("folder2/out.png"), links)) << "not only begins alike";
    }
}

TEST_F(NamedFile, WhatLinksLeadToIsForTheCallerToSay)
{
    for (const std::string name : {"away.png", "away/out.png"}) {
        EXPECT_TRUE(isTaken(name, Links::followed)) << name;
        EXPECT_FALSE(isTaken(name, Links::staysInside)) << name;
    }
    EXPECT_FALSE(isTaken("away/../out.png", Links::followed)) << "which is out.png";
    EXPECT_FALSE(isTaken("loop", Links::staysInside));
}

TEST_F(NamedFile, MayBeAnywhereIfTheUserVouchesForIt)
{
    EXPECT_EQ(namedFile(folder(), "/etc/passwd", "list.txt", Links::staysInside, true),
              "/etc/passwd");
    EXPECT_EQ(namedFile(folder(), "../out.png", "list.txt", Links::followed, true),
              folder() / "../out.png");
}

TEST_F(NamedFile, ALinkIsSaidToBeOne)
{
    try {
        static_cast<void>(namedFile(folder(), "away.png", "r.rawlog", Links::staysInside, false));
        FAIL() << "taken";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("a link out of"), std::string::npos) << e.what();
    }
}

TEST_F(NamedFile, IsNamedInTheRefusal)
{
    try {
        static_cast<void>(
            namedFile(folder(), "../\x1B[2J.png", "list.txt", Links::followed, false));
        FAIL() << "taken";
    } catch (const InputError& e) {
        for (const char* part : {"'list.txt'", "'../\\x1b[2J.png'", "--trust-paths"})
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
}

TEST_F(NamedFile, ANameThatIsTooLongIsSaidToBe)
{
    for (const bool trusted : {false, true})
        for (const Links links : {Links::followed, Links::staysInside}) try
            {
                static_cast<void>(
                    namedFile(folder(), std::string(5000, 'x'), "list.txt", links, trusted));
                FAIL() << "taken";
            } catch (const InputError& e) {
                const std::string told = e.what();
                EXPECT_NE(told.find("too long"), std::string::npos) << told;
                EXPECT_LT(told.size(), 250U) << told;
            }
}
