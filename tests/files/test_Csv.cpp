// SPDX-License-Identifier: BSD-3-Clause
#include "files/Csv.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
using Fields = std::vector<std::string>;

std::vector<Fields> fieldsOf(const std::string& text)
{
    std::vector<Fields> all;
    for (const CsvRow& row : parseCsv(text, "a.csv")) all.push_back(row.fields);
    return all;
}

std::string complaint(const std::string& text, const std::vector<std::string>& header = {})
{
    try {
        header.empty() ? parseCsv(text, "a.csv") : parseCsv(text, header, "a.csv");
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}
}  // namespace

TEST(Csv, everySeparatorAndLineEndGivesTheSameFields)
{
    const std::vector<Fields> expected = {{"1", "wine glass"}, {"2", ""}};
    for (const char* text :
         {"1,wine glass\n2,\n", "1,wine glass\r\n2,\r\n", "1;wine glass\n2;",
          "1\twine glass\n2\t\n", " 1 , wine glass \n\n 2 ,\n  \n", "\"1\",\"wine glass\"\n2,\"\""})
        EXPECT_EQ(fieldsOf(text), expected) << text;
    EXPECT_TRUE(fieldsOf("").empty());
    EXPECT_TRUE(fieldsOf("\r\n \n").empty());
}

TEST(Csv, theFirstLineTellsWhatSeparates)
{
    EXPECT_EQ(fieldsOf("a\tb;c,d\n"), (std::vector<Fields>{{"a", "b;c,d"}}));
    EXPECT_EQ(fieldsOf("a;b,c\nd,e\n"), (std::vector<Fields>{{"a", "b,c"}, {"d,e"}}));
    EXPECT_EQ(fieldsOf("\"a;b\",c\n"), (std::vector<Fields>{{"a;b", "c"}}));
}

TEST(Csv, aLineForSpreadsheetsTellsWhatSeparates)
{
    const std::vector<Fields> expected = {{"a;b", "c"}, {"1", "2;3"}};
    EXPECT_EQ(fieldsOf("sep=,\r\na;b,c\r\n1,2;3\r\n"), expected);
    EXPECT_EQ(fieldsOf("sep=|\na;b|c\n1|2;3"), expected);
    EXPECT_EQ(fieldsOf("sep=\t\na;b\tc\n1\t2;3\n"), expected);
    EXPECT_EQ(parseCsv("sep=;\na;b\n", "a.csv").at(0).line, 2U);
    EXPECT_EQ(fieldsOf("sep=ab\nc\n"), (std::vector<Fields>{{"sep=ab"}, {"c"}}));
    EXPECT_TRUE(fieldsOf("sep=;").empty());
}

TEST(Csv, noBreakSpacesAroundFieldsAreBlanks)
{
    EXPECT_EQ(fieldsOf("\xC2\xA0"
                       "a\xC2\xA0\xC2\xA0 ,\xC2\xA0,\xC3\xA0\n"),
              (std::vector<Fields>{{"a", "", "\xC3\xA0"}}))
        << "the last byte of an \xC3\xA0 is no space";
}

TEST(Csv, quotesHoldAnything)
{
    EXPECT_EQ(fieldsOf("1,\"a, \"\"b\"\"\"\n"), (std::vector<Fields>{{"1", "a, \"b\""}}));
    EXPECT_EQ(fieldsOf("1,12\" monitor\n"), (std::vector<Fields>{{"1", "12\" monitor"}}))
        << "only those that begin a field are quotes";
    const auto rows = parseCsv("1,\"a\nb\"\n\n2,c\n", "a.csv");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].fields[1], "a\nb");
    EXPECT_EQ(rows[0].line, 1U);
    EXPECT_EQ(rows[1].line, 4U);
}

TEST(Csv, saysInWhichLine)
{
    EXPECT_EQ(complaint("a,b\nc,\"d\ne\n"), "line 2 of a.csv has a field whose quotes do not end");
    EXPECT_EQ(complaint("a,b\n\"c\" d,e\n"),
              "line 2 of a.csv has more behind the quotes of a field");
    for (const char* odd :
         {"St\xFChle", "\xC3", "\x80", "\xE2\x82", "\xC0\xAF", "\xF8\x88\x80\x80"})
        EXPECT_EQ(complaint(std::string("1,\xC3\xBC\n2,") + odd + "\n"),
                  "line 2 of a.csv is not UTF-8 text: save the file as UTF-8")
            << odd;
    EXPECT_EQ(complaint("1,\xE2\x82\xAC \xF0\x9F\xAA\x91\n"), "");
}

TEST(Csv, aHeaderIsWhatItShouldBe)
{
    const std::vector<std::string> header = {"name", "class"};
    const auto rows = parseCsv("name;class\r\na;b\r\n", header, "a.csv");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].fields, (Fields{"a", "b"}));
    EXPECT_EQ(complaint("name,klass\na,b\n", header),
              "a.csv must begin with the line 'name,class'.");
    EXPECT_EQ(complaint("", header), "a.csv must begin with the line 'name,class'.");
    EXPECT_EQ(complaint("name,class\n\na,b,c\n", header),
              "line 3 of a.csv has 3 fields instead of 2.");
}
