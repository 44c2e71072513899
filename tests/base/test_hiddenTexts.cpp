// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/hiddenTexts.h"
#include "voxeland/base/printable.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(HiddenTexts, AreShownAsSomethingElse)
{
    EXPECT_EQ(withoutHidden("a swordfish b"), "a swordfish b");
    hideText("Swordfish", "$env{PASSWORD}");
    EXPECT_EQ(withoutHidden("swordfish, SWORDFISHes"), "$env{PASSWORD}, $env{PASSWORD}es");
    EXPECT_EQ(printable("\tswordfish"), "\\t$env{PASSWORD}");
    EXPECT_EQ(printableSentence("no file 'swordfish'"), "no file '$env{PASSWORD}'");
}

TEST(HiddenTexts, NoPartIsLeftWhereATextIsCut)
{
    const std::string secret = "0123456789abcdefghijklmnopqrstuvwxyz";
    hideText(secret, "*");
    const std::string around(70, '.');
    for (const auto& shown :
         {printable(around + secret + around), printableSentence(around + secret + around, 90)})
        EXPECT_TRUE(shown.find("01234") == std::string::npos &&
                    shown.find("vwxyz") == std::string::npos)
            << shown;
}

TEST(HiddenTexts, TheLongestGoesFirst)
{
    hideText("abcdefgh", "short");
    hideText("abcdefghijkl", "long");
    EXPECT_EQ(withoutHidden("abcdefghijklm"), "longm");
}

TEST(HiddenTexts, ShowingAgainChangesNothing)
{
    hideText("HARBOUR", "$env{HARBOUR}");
    EXPECT_EQ(withoutHidden("HARBOUR $env{HARBOUR}"), "$env{HARBOUR} $env{HARBOUR}");
}

TEST(HiddenTexts, CommonWordsAreNot)
{
    hideText("chair", "*");
    hideText("", "*");
    EXPECT_EQ(withoutHidden("chair"), "chair");
}
