// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/Ini.h"
#include "voxeland/plugins/OptionList.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

using namespace voxeland;

namespace
{
enum class Taste
{
    sweet,
    sour
};

struct Options
{
    std::string name = "none";
    bool enabled = false;
    int count = -1;
    uint32_t size = 5;
    double share = 0.125;
    Taste taste = Taste::sweet;
    OptionList list;

    Options()
    {
        list.add("name", name, "A name");
        list.add("enabled", enabled, "Whether");
        list.add("count", count, {-10, 10}, "How many");
        list.add("size", size, {1, 4e9}, "How large [voxels]");
        list.add("share", share, {0, 1}, "How much");
        list.add("taste", taste,
                 std::vector<std::pair<std::string, Taste>>{{"sweet", Taste::sweet},
                                                            {"sour", Taste::sour}},
                 "Which taste");
    }

    std::vector<std::string> load(const std::string& text)
    {
        std::vector<std::string> problems;
        list.load(Ini::fromText("[s]\n" + text, "a text"), "s", problems);
        return problems;
    }
};

/** The only problem with one line, or a text that says how many there are. */
std::string problemOf(const std::string& line)
{
    const auto problems = Options().load(line);
    return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}
}  // namespace

TEST(OptionList, ReadsValuesOfAllKinds)
{
    Options o;
    EXPECT_TRUE(o.load("name = two words\nenabled = Yes\ncount = -3\nsize = 4000000000\n"
                       "share = 2.5e-1 // a comment\ntaste = sour\n")
                    .empty());
    EXPECT_EQ(o.name, "two words");
    EXPECT_TRUE(o.enabled);
    EXPECT_EQ(o.count, -3);
    EXPECT_EQ(o.size, 4000000000u);
    EXPECT_EQ(o.share, 0.25);
    EXPECT_EQ(o.taste, Taste::sour);
}

TEST(OptionList, WhatIsNotNamedKeepsItsDefault)
{
    Options o;
    EXPECT_TRUE(o.load("").empty());
    EXPECT_EQ(o.name, "none");
    EXPECT_EQ(o.count, -1);
    EXPECT_EQ(o.share, 0.125);
}

TEST(OptionList, UnknownKeysNameTheNearest)
{
    EXPECT_TRUE(contains(problemOf("shrae = 1"), "did you mean 'share'?"));
    EXPECT_TRUE(contains(problemOf("enabeld = 1"), "did you mean 'enabled'?"));
    EXPECT_TRUE(contains(problemOf("shrae = 1"), "[s]"));
    const std::string far = problemOf("quite_another_thing = 1");
    EXPECT_TRUE(contains(far, "'quite_another_thing'"));
    EXPECT_FALSE(contains(far, "did you mean"));
}

TEST(OptionList, BadNumbersAreProblems)
{
    for (const char* line : {"share = much", "share = 0.5.5", "share = 0,5", "share = 0.5 m",
                             "share =", "share = nan", "count = 1.5", "count = 99", "size = -1",
                             "size = 0", "share = -0.1", "share = 1.1", "count = 1e99"})
    {
        const std::string problem = problemOf(line);
        EXPECT_TRUE(contains(problem, "[s] ")) << line << ": " << problem;
    }
    EXPECT_TRUE(contains(problemOf("share = 1.1"), "within 0 and 1"));
    EXPECT_TRUE(contains(problemOf("count = 1.5"), "whole number"));
}

TEST(OptionList, BadWordsAreProblemsThatListTheGoodOnes)
{
    EXPECT_TRUE(contains(problemOf("taste = bitter"), "sweet | sour"));
    EXPECT_TRUE(contains(problemOf("enabled = perhaps"), "true"));
}

TEST(OptionList, ATextThatCouldNotBeReadBackIsAProblem)
{
    Options o;
    Ini ini;
    ini.set("s.name=a\\");
    std::vector<std::string> problems;
    o.list.load(ini, "s", problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_TRUE(contains(problems[0], "backslash")) << problems[0];
    EXPECT_EQ(o.name, "none");
}

TEST(OptionList, ATrailingCommentWithAHashIsExplained)
{
    for (const char* line :
         {"share = 0.5 # half", "enabled = true # on", "taste = sour # as lemons"})
        EXPECT_TRUE(contains(problemOf(line), "' //'")) << problemOf(line);
}

TEST(OptionList, AllProblemsAreReportedAtOnce)
{
    EXPECT_EQ(Options().load("nmae = x\ncount = many\ntaste = bitter\nenabled = yes\n").size(), 3u);
}

TEST(OptionList, WhatIsPrintedReadsBack)
{
    Options written;
    written.name = "a b";
    written.enabled = true;
    written.count = -7;
    written.size = 4000000000u;
    written.share = 1.0 / 3;
    written.taste = Taste::sour;
    std::ostringstream out;
    written.list.print(out, "s");
    for (const char* comment : {"How large [voxels]", "sweet | sour"})
        EXPECT_TRUE(contains(out.str(), comment));

    Options read;
    std::vector<std::string> problems;
    read.list.load(Ini::fromText(out.str(), "printed"), "s", problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.enabled, written.enabled);
    EXPECT_EQ(read.count, written.count);
    EXPECT_EQ(read.size, written.size);
    EXPECT_EQ(read.share, written.share);
    EXPECT_EQ(read.taste, written.taste);
}

namespace
{
/** A method of two parts, the first of which had a key of its own once. */
struct Ablated
{
    bool usesMud = true, usesRain = true;
    std::vector<std::string> problems;
    std::string printed;

    explicit Ablated(const std::string& line)
    {
        OptionList list;
        list.addAblation({{"mud", usesMud, "use_mud"}, {"rain", usesRain}});
        list.load(Ini::fromText("[s]\n" + line + "\n", "the test"), "s", problems);
        std::ostringstream out;
        list.print(out, "s");
        printed = out.str();
    }
    [[nodiscard]] std::vector<bool> parts() const { return {usesMud, usesRain}; }
};
using Parts = std::vector<bool>;
}  // namespace

TEST(OptionList, AnAblationNamesTheParts)
{
    EXPECT_EQ(Ablated("").parts(), (Parts{true, true}));
    EXPECT_EQ(Ablated("ablation = rain").parts(), (Parts{true, false}));
    EXPECT_EQ(Ablated("ablation = rain , mud").parts(), (Parts{false, false}));
    EXPECT_EQ(Ablated("ablation =").parts(), (Parts{true, true}));
    EXPECT_TRUE(contains(Ablated("ablation = rain").printed, "\nablation = rain\n"));
    EXPECT_TRUE(contains(Ablated("").printed, "mud, rain\nablation = \n"));
    const Ablated wrong("ablation = rain, snow");
    ASSERT_EQ(wrong.problems.size(), 1U);
    EXPECT_TRUE(contains(wrong.problems[0], "'snow': there are mud, rain")) << wrong.problems[0];
    EXPECT_EQ(wrong.parts(), (Parts{true, true}));
}

TEST(OptionList, APartsFormerKeyIsStillUnderstood)
{
    const Ablated former("use_mud = false");
    EXPECT_TRUE(former.problems.empty());
    EXPECT_EQ(former.parts(), (Parts{false, true}));
    EXPECT_TRUE(contains(former.printed, "ablation = mud\n")) << former.printed;
    EXPECT_FALSE(contains(former.printed, "use_mud"));
    EXPECT_TRUE(contains(Ablated("use_mad = false").problems.at(0), "no key 'use_mad'"));
    EXPECT_FALSE(contains(Ablated("use_mad = false").problems.at(0), "'use_mud'"))
        << "a former key is not suggested";
}

TEST(OptionList, KeysForExpertsArePrintedWhereTheyAreChanged)
{
    int depth = 1, width = 2, height = 3;
    OptionList list;
    list.add("depth", depth, {0, 9}, "How deep");
    list.forExperts();
    list.add("width", width, {0, 9}, "How wide");
    list.add("height", height, {0, 9}, "How high");
    std::vector<std::string> problems;
    list.load(Ini::fromText("[s]\nheight = 4\n", "the test"), "s", problems);
    const auto printed = [&](OptionList::Keys keys) {
        std::ostringstream out;
        list.print(out, "s", keys);
        return out.str();
    };
    EXPECT_EQ(printed(OptionList::Keys::common),
              "[s]\n# How deep\ndepth = 1\n# How high\nheight = 4\n");
    EXPECT_EQ(printed(OptionList::Keys::all),
              "[s]\n# How deep\ndepth = 1\n# How wide\nwidth = 2\n# How high\nheight = 4\n");
}

TEST(OptionList, RetiredKeysAreReadAndDoNothing)
{
    int number = 1;
    OptionList list;
    list.add("number", number, {0, 9}, "A number");
    list.retire("former");
    std::vector<std::string> problems;
    list.load(Ini::fromText("[s]\nFormer = what was here\nnumber = 2\n", "the test"), "s",
              problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(number, 2);
    std::ostringstream out;
    list.print(out, "s");
    EXPECT_EQ(out.str().find("former"), std::string::npos);
}

namespace
{
/** Options of which a map may say some. */
struct GuardedOptions
{
    std::string file = "default.txt", label = "none";
    bool safe = true;
    int count = 0;
    OptionList list;

    explicit GuardedOptions(const Ini& ini)
    {
        list.add("file", file, "A file");
        list.add("label", label, "A label", OptionList::anyValue);
        list.add("safe", safe, "Whether to be careful", OptionList::noValue);
        list.add("count", count, {0, 9}, "How many");
        std::vector<std::string> problems;
        list.load(ini, "s", problems);
        EXPECT_TRUE(problems.empty()) << problems.front();
    }
    [[nodiscard]] std::string printed() const
    {
        std::ostringstream out;
        list.print(out, "s");
        return out.str();
    }
};

const std::string ALL = "[s]\nfile = a.txt\nlabel = b\nsafe = no\ncount = 3\n";
}  // namespace

TEST(OptionList, OfAMapOnlyWhatIsHarmlessIsTaken)
{
    const GuardedOptions o(Ini::fromMap(ALL, "m.voxeland"));
    EXPECT_EQ(o.file, "default.txt");
    EXPECT_EQ(o.label, "b");
    EXPECT_TRUE(o.safe);
    EXPECT_EQ(o.count, 3);
    EXPECT_EQ(o.list.leftToUser(),
              (std::vector<std::string>{"[s] file = 'a.txt'", "[s] safe = 'no'"}));
    const GuardedOptions users(Ini::fromText(ALL, "my.ini"));
    EXPECT_EQ(users.file, "a.txt");
    EXPECT_FALSE(users.safe);
    EXPECT_TRUE(users.list.leftToUser().empty());
}

TEST(OptionList, WhatIsTheDefaultAnywayIsNotTold)
{
    const GuardedOptions o(Ini::fromMap("[s]\nfile = default.txt\nsafe = true\n", "m.voxeland"));
    EXPECT_TRUE(o.list.leftToUser().empty());
}

TEST(OptionList, WhatTheUserSaysOverAMapIsTaken)
{
    Ini ini = Ini::fromMap(ALL, "m.voxeland");
    ini.set("s.file=c.txt");
    const GuardedOptions o(ini);
    EXPECT_EQ(o.file, "c.txt");
    EXPECT_EQ(o.list.leftToUser(), std::vector<std::string>{"[s] safe = 'no'"});
}

TEST(OptionList, OfAMapOnlyPlainTextsAreTaken)
{
    for (const std::string label : {"\xC2\x9B"
                                    "31m",
                                    "cup\xE2\x80\xAEgpj", "${X}", "$eval{1+1}", "a$env{HOME}"})
    {
        const std::string text = "[s]\nlabel = " + label + "\n";
        EXPECT_EQ(GuardedOptions(Ini::fromMap(text, "m.voxeland")).label, "none") << label;
    }
    const std::string text = "[s]\nlabel = S\xC3\xBC\xC3\x9F 5$ {a}\n";
    EXPECT_EQ(GuardedOptions(Ini::fromMap(text, "m.voxeland")).label, "S\xC3\xBC\xC3\x9F 5$ {a}");
}

TEST(OptionList, OfUrlsNoPasswordIsShown)
{
    std::string url = "http://own";
    OptionList list;
    list.addUrl("url", url, "A server");
    const auto problemOf = [&](const std::string& value) {
        std::vector<std::string> problems;
        list.load(Ini::fromText("[s]\nurl = " + value + "\n", "my.ini"), "s", problems);
        return problems.empty() ? "" : problems[0];
    };
    for (const char* login : {"https://me:pass@", "https://me:p@s/s@", "ftp://me@", "me:pass@"})
        EXPECT_EQ(problemOf(std::string(login) + "host/v1"),
                  "[s] url = '*@host/v1' is not of the form http[s]://host[:port]/path");
    setenv("VOXELAND_TEST_VALUE", "host", 1);
    EXPECT_NE(problemOf("https://me:pass@$env{VOXELAND_TEST_VALUE}"), "");
    EXPECT_TRUE(contains(problemOf("ftp://host"), "'ftp://host' is not of the form"));
    std::ostringstream printed;
    list.print(printed, "s");
    EXPECT_TRUE(contains(printed.str(), "\nurl = http://own\n")) << printed.str();
    EXPECT_EQ(problemOf("https://host:1/v1"), "");
    EXPECT_EQ(url, "https://host:1/v1");
}

TEST(OptionList, PrintsTheEnvironmentByName)
{
    setenv("VOXELAND_TEST_VALUE", "7", 1);
    const std::string value = "$env{VOXELAND_TEST_VALUE}";
    const GuardedOptions o(Ini::fromText(
        "[s]\nfile = " + value + "\nlabel = " + value + "\ncount = " + value + "\n", "my.ini"));
    EXPECT_EQ(o.file, "7");
    EXPECT_EQ(o.label, "7");
    EXPECT_TRUE(contains(o.printed(), "\nfile = " + value + "\n")) << o.printed();
    EXPECT_TRUE(contains(o.printed(), "\nlabel = " + value + "\n"));
    EXPECT_TRUE(contains(o.printed(), "\ncount = 7\n")) << "a number tells nothing";
    // A map that holds it does not get it expanded, nor taken as it is.
    const GuardedOptions again(Ini::fromMap(o.printed(), "m.voxeland"));
    EXPECT_EQ(again.label, "none");
    EXPECT_EQ(again.count, 7);
    EXPECT_EQ(again.list.leftToUser().size(), 2u);
}

TEST(OptionList, PrintsNoTextsThatMrptMayHaveExpanded)
{
    const mrpt::config::CConfigFileMemory others("[p_s]\nfile = a.txt\nlabel = b\n");
    Ini ini;
    ini.setFromPrefixedSections(others, "p", {"s"});
    const GuardedOptions o(ini);
    EXPECT_EQ(o.file, "a.txt");
    EXPECT_TRUE(contains(o.printed(), "\nfile = \n")) << o.printed();
    EXPECT_TRUE(contains(o.printed(), "\nlabel = b\n"));
}

TEST(OptionList, ShowsTheNameOfAVariableOnlyIfThereIsOne)
{
    setenv("VOXELAND_TEST_KEY", "x", 1);
    const auto shown = [](const std::string& value) {
        std::string variable;
        OptionList list;
        list.addVariableName("key_env", variable, "Where the key is");
        std::vector<std::string> problems;
        list.load(Ini::fromText("[s]\nkey_env = " + value + "\n", "a text"), "s", problems);
        std::ostringstream out;
        list.print(out, "s");
        EXPECT_TRUE(variable == value || !problems.empty());
        for (const std::string& problem : problems) out << problem;
        return out.str();
    };
    EXPECT_TRUE(contains(shown("VOXELAND_TEST_KEY"), "key_env = VOXELAND_TEST_KEY\n"));
    for (const char* key : {"sk-Written-0123456789", "gsk_Written0123456789", "0123456789abcdef"})
        EXPECT_FALSE(contains(shown(key), key)) << shown(key);
    EXPECT_TRUE(contains(shown("sk-Written-0123456789"), "must be the name of an environment"));
    EXPECT_TRUE(contains(shown("0123456789abcdef"), "must be the name of an environment"));
}

TEST(OptionList, WhatConcernsARunIsNotKeptInMaps)
{
    uint32_t threads = 3, every = 1;
    OptionList list;
    list.add("threads", threads, {0, 99}, "How many at a time");
    list.concernsRun();
    list.add("every", every, {0, 99}, "How often");
    std::vector<std::string> problems;
    list.load(Ini::fromText("[s]\nthreads = 4\nevery = 5\n", "a text"), "s", problems);
    std::ostringstream run, map;
    list.print(run, "s");
    list.print(map, "s", OptionList::Keys::ofMap);
    EXPECT_EQ(run.str(), "[s]\n# How many at a time\nthreads = 4\n# How often\nevery = 5\n");
    EXPECT_EQ(map.str(), "[s]\n# How many at a time\nthreads = 3\n# How often\nevery = 5\n");
}
