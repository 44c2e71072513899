// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/lowerCase.h"
#include "voxeland/base/nearestWord.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(LowerCase, LeavesAllButLatinLettersAsTheyAre)
{
    EXPECT_EQ(lowerCase("Dining TABLE_1 [Z@`"), "dining table_1 [z@`");
    EXPECT_EQ(lowerCase("\xC3\x84pfel"), "\xC3\x84pfel") << "UTF-8 stays UTF-8";
}

TEST(NearestWord, IsTheOneWithFewestEdits)
{
    const std::vector<std::string> words = {"min_depth", "max_depth", "threads"};
    EXPECT_EQ(nearestWord("max_dept", words), "max_depth");
    EXPECT_EQ(nearestWord("MIN_DEPTH", words), "min_depth");
    EXPECT_EQ(nearestWord("thread", words), "threads");
    EXPECT_EQ(nearestWord("xyz", words), "");
    EXPECT_EQ(nearestWord("anything", {}), "");
}
