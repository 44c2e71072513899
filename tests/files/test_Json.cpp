// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/Json.h"

#include <gtest/gtest.h>

using namespace voxeland;
using nlohmann::json;

namespace
{
std::string errorOf(const std::string& text)
{
    try {
        (void)parseJson(text, "a.json");
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

/** Lists in each other. */
std::string nested(size_t depth)
{
    return std::string(depth, '[') + std::string(depth, ']');
}
}  // namespace

TEST(Json, readsWhatPythonWrites)
{
    const json expected = {
        {"a", nullptr}, {"b", {1, nullptr, nullptr}}, {"c", "NaN -Infinity \\\""}};
    EXPECT_EQ(
        parseJson(R"({"a": NaN, "b": [1, -Infinity, Infinity], "c": "NaN -Infinity \\\""})", ""),
        expected);
}

TEST(Json, whatIsNestedDeeperThanTheLimitIsRefused)
{
    EXPECT_EQ(parseJson(nested(JsonLimits::DEPTH), "").dump(), nested(JsonLimits::DEPTH));
    EXPECT_EQ(
        errorOf(nested(JsonLimits::DEPTH + 1)),
        "a.json nests lists and objects deeper than 100 levels: it is damaged or no file that "
        "is meant here");
    const std::string open(5000000, '[');
    EXPECT_NE(errorOf(open).find("deeper"), std::string::npos);
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += R"({"a":)";
    EXPECT_NE(errorOf(objects).find("deeper"), std::string::npos);
    EXPECT_FALSE(jsonFrom(open));
}

TEST(Json, bracketsInTextsDoNotCount)
{
    const std::string text = "\"\\\"" + std::string(1000, '[') + "\"";
    EXPECT_EQ(parseJson(text, "").get<std::string>(), "\"" + std::string(1000, '['));
}

TEST(Json, moreValuesThanTheLimitAreRefused)
{
    std::string list = "[";
    list.reserve(2 * JsonLimits::VALUES + 10);
    for (size_t i = 0; i <= JsonLimits::VALUES; ++i) list += "0,";
    EXPECT_EQ(errorOf(list + "0]"), "a.json holds more than 50 million values: divide it");
}

TEST(Json, saysWhatIsWrong)
{
    EXPECT_EQ(errorOf(" \n"), "a.json is empty: JSON is expected");
    EXPECT_EQ(errorOf("{\"a\": 1,\n \"b\": ]"),
              "a.json is not valid JSON at line 2, column 7: correct it there");
    EXPECT_EQ(errorOf("[1, 2"),
              "a.json is not valid JSON at line 1, column 6, its end: it is cut off");
    EXPECT_EQ(errorOf("[1, -9e480]"),
              "a.json has the number -9e480, which is greater than any that can be computed with: "
              "correct it");
}

TEST(Json, readsLinesOfObjects)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("a.json");
    const json expected = json::parse(R"([{"a":1},{"a":null}])");
    test::writeFile(file, "{\"a\":1}\n\n{\"a\":NaN}\n");
    EXPECT_EQ(readJsonOrLines(file), expected);
    test::writeFile(file, "{\"a\":1}\n");
    EXPECT_EQ(readJsonOrLines(file), expected[0]);
    test::writeFile(file, "{\n\"a\":1\n}\n");
    EXPECT_EQ(readJsonOrLines(file), expected[0]);
    test::writeFile(file, "{\"a\":1}\n" + nested(200000) + "\n");
    EXPECT_THROW((void)readJsonOrLines(file), InputError);
}
