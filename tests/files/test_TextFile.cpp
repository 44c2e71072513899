// SPDX-License-Identifier: BSD-3-Clause
#include "files/TextFile.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(TextFile, isReadWithoutItsByteOrderMark)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("a.txt");
    for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
        test::writeFile(file, mark + "a\r\n\xC3\xBC");
        EXPECT_EQ(readTextFile(file), "a\r\n\xC3\xBC");
    }
}

TEST(TextFile, linesThatEndWithCrAloneAreLines)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("a.txt");
    test::writeFile(file, "a\rb\r\nc\r");
    EXPECT_EQ(readTextFile(file), "a\nb\r\nc\n");
}

TEST(TextFile, whatIsNoTextIsNamed)
{
    const test::TemporaryFolder folder;
    const auto complaint = [](const std::string& file) {
        try {
            readTextFile(file, "label map");
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    const std::string file = folder.file("a.txt");
    EXPECT_EQ(complaint(file), "cannot read the label map " + file + ": there is no such file");
    EXPECT_EQ(
        complaint(folder.path().string()),
        "cannot read the label map " + folder.path().string() + ": it is a folder: name a file");
    for (const std::string mark : {"\xFF\xFE", "\xFE\xFF"}) {
        test::writeFile(file, mark + std::string("a\0b\0", 4));
        EXPECT_EQ(complaint(file), "the label map " + file + " is UTF-16 text: save it as UTF-8");
    }
    for (const std::string start : {"PK\x03\x04", "\xD0\xCF\x11\xE0"}) {
        test::writeFile(file, start + "...");
        EXPECT_EQ(complaint(file), "the label map " + file + " is a spreadsheet: save it as CSV");
    }
}
