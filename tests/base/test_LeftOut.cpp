// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/LeftOut.h"

#include <gtest/gtest.h>

using voxeland::LeftOut;

TEST(LeftOut, CountsAndNamesTheFirst)
{
    LeftOut leftOut;
    EXPECT_EQ(leftOut.count(), 0u);
    EXPECT_EQ(leftOut.first(), "");
    leftOut.add("line 3 of a.txt is no pose");
    leftOut.add("line 7 of a.txt is no pose");
    EXPECT_EQ(leftOut.count(), 2u);
    EXPECT_EQ(leftOut.first(), "line 3 of a.txt is no pose");
    EXPECT_EQ(leftOut.told("line"),
              "2 lines left out (--strict: an error), the first: line 3 of a.txt is no pose");
}

TEST(LeftOut, IsAnErrorWhereOneIsStrict)
{
    LeftOut leftOut(true);
    try {
        leftOut.add("line 3 of a.txt is no pose");
        FAIL() << "nothing was thrown";
    } catch (const voxeland::InputError& e) {
        EXPECT_STREQ(e.what(), "line 3 of a.txt is no pose");
    }
}
