// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/printable.h"

#include <gtest/gtest.h>

using voxeland::printable;
using voxeland::printableSentence;

TEST(Printable, LeavesWhatAPersonReads)
{
    for (const char* text :
         {"", "cup", "potted plant", "C:\\maps", "S\xC3\xBC\xC3\x9Fholz",
          "\xE6\xA4\x85\xE5\xAD\x90", "\xF0\x9F\xAA\x91", "it's \"fine\" {0} %n"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsWhatControlsATerminal)
{
    EXPECT_EQ(printable("\x1B[2Jfoo"), "\\x1b[2Jfoo");
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(printable("a\nb\rc\td"), "a\\nb\\rc\\td");
    EXPECT_EQ(printable("\x07\x08\x7F"), "\\x07\\x08\\u007f");
    EXPECT_EQ(printable("\xC2\x9B"
                        "31m"),
              "\\u009b31m");  // CSI as one character
    EXPECT_EQ(printable("\x9B"
                        "31m"),
              "\\x9b31m");  // ... and as a byte of Latin-1
}

TEST(Printable, ShowsWhatTurnsTheDirectionOfWriting)
{
    EXPECT_EQ(printable("cup\xE2\x80\xAEgpj"), "cup\\u202egpj");
    EXPECT_EQ(printable("\xE2\x81\xA6x\xE2\x81\xA9"), "\\u2066x\\u2069");
    EXPECT_EQ(printable("a\xE2\x80\xA8z"), "a\\u2028z");  // line separator
    EXPECT_EQ(printable("\xEF\xBB\xBFx"), "\\ufeffx");
}

TEST(Printable, ShowsBytesThatAreNoCharacter)
{
    EXPECT_EQ(printable("caf\xE9"), "caf\\xe9");              // Latin-1
    EXPECT_EQ(printable("\xC0\x9B"), "\\xc0\\x9b");           // longer than needed
    EXPECT_EQ(printable("\xE0\x82\x9B"), "\\xe0\\x82\\x9b");  // ... of three bytes
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // half a surrogate pair
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
    EXPECT_EQ(printable("\xE2\x82"), "\\xe2\\x82");  // cut off
}

TEST(Printable, ShowsBeginAndEndOfALongText)
{
    EXPECT_EQ(printable("0123456789", 10), "0123456789");
    EXPECT_EQ(printable("0123456789a", 10), "0123...89a");
    EXPECT_EQ(printable(std::string(50000000, 'x')).size(), 80u);
}

TEST(Printable, CutsBetweenCharacters)
{
    const std::string word = "\xC3\xA4\xC3\xB6\xC3\xBC";  // three characters of two bytes
    EXPECT_EQ(printable(word + word + word, 8), word + "..." + "\xC3\xB6\xC3\xBC");
    // Escapes are not divided either.
    EXPECT_EQ(printable("\x01\x02\x03\x04\x05\x06", 11), "\\x01...");
    EXPECT_EQ(printable("\x01\x02\x03\x04\x05\x06", 12), "\\x01...\\x06");
    const std::string chairs = "\xF0\x9F\xAA\x91\xF0\x9F\xAA\x91\xF0\x9F\xAA\x91";
    EXPECT_EQ(printable(chairs + chairs + chairs, 8).size(), 3 + 4 * 5u);
}

TEST(PrintableSentence, ShortensLongWordsFirst)
{
    const std::string path = "'/" + std::string(400, 'p') + "/map.voxeland'";
    const std::string sentence =
        printableSentence("cannot write " + path + ": No space left on device: free some space");
    EXPECT_LE(sentence.size(), 300u);
    EXPECT_EQ(sentence.compare(0, 18, "cannot write '/ppp"), 0) << sentence;
    const std::string end = "/map.voxeland': No space left on device: free some space";
    EXPECT_EQ(sentence.substr(sentence.size() - end.size()), end);
}

TEST(PrintableSentence, LeavesASentenceThatFits)
{
    const std::string path = "'/" + std::string(200, 'p') + "'";
    EXPECT_EQ(printableSentence("cannot read " + path), "cannot read " + path);
    EXPECT_EQ(printableSentence("two  blanks"), "two  blanks");
}

TEST(PrintableSentence, CutsOneOfManyWords)
{
    std::string many = "there are: ";
    for (int i = 0; i < 1000000; ++i) many += "word ";
    EXPECT_EQ(printableSentence(many + "(see --help)").size(), 300u);
    const std::string cut = printableSentence(many + "(see --help)");
    EXPECT_EQ(cut.compare(0, 16, "there are: word "), 0);
    EXPECT_EQ(cut.substr(cut.size() - 12), "(see --help)");
}
