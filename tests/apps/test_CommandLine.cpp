// SPDX-License-Identifier: BSD-3-Clause
/** What a command line may be, and what is said of one that is wrong. */
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "common/SetArgument.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

#include <cstdint>

using namespace voxeland;

namespace
{
using Words = std::vector<std::string>;

const char* const DESCRIPTION = "Does what a test needs.\n\n  program -i here \"a b\"";

struct Arguments : apps::CommandLine
{
    explicit Arguments(Rest rest = Rest::refused) : CommandLine(DESCRIPTION, rest) {}

    apps::Switch strict{*this, "--strict", "What is odd is an error"};
    apps::SetArgument set{*this, "configuration"};
    apps::Number<uint32_t> every{*this, "--every", "N", "Use one in so many", 7};
    apps::Number<int> offset{*this, "--offset", "N", "Where to begin", -2};
    apps::Number<double> height{*this, "--height", "METRES", "Above the floor", 1.25};
    apps::Text up{*this, "--up", "X,Y,Z", "Direction of up"};
    apps::Text title{*this, "--title", "TEXT", "Title", "none"};
    apps::Text output{*this, "-o,--output", "FILE", "What to write"};
};

/** Arguments as of a program that needs some of them. */
struct Needy : Arguments
{
    apps::Text input{*this, "-i,--input", "FILE", "What to read", apps::Presence::required};
    apps::Texts truths{*this, "--gt", "DIR", "What is true", apps::Presence::required};
    apps::Text map{*this, "map", "MAP", "Map to read", apps::Presence::required};
};

bool parse(apps::CommandLine& line, const Words& words)
{
    std::vector<const char*> argv = {"/usr/bin/program"};
    for (const std::string& word : words) argv.push_back(word.c_str());
    return line.parse(static_cast<int>(argv.size()), argv.data());
}

/** What is said of a wrong command line. */
std::string refusal(apps::CommandLine& line, const Words& words)
{
    try {
        static_cast<void>(parse(line, words));
    } catch (const ConfigurationError& e) {
        return e.what();
    }
    return "taken";
}

std::string refusal(const Words& words)
{
    Arguments line;
    return refusal(line, words);
}

std::string refusalOfNeedy(const Words& words)
{
    Needy line;
    return refusal(line, words);
}

std::string titleOf(const Words& words)
{
    Arguments line;
    EXPECT_TRUE(parse(line, words));
    EXPECT_TRUE(line.title.isSet());
    return line.title.value();
}

std::string printed(const Words& words)
{
    Arguments line;
    testing::internal::CaptureStdout();
    EXPECT_FALSE(parse(line, words));
    return testing::internal::GetCapturedStdout();
}
}  // namespace

TEST(CommandLine, presetsHoldWithoutOptions)
{
    Arguments line;
    EXPECT_TRUE(parse(line, {}));
    EXPECT_FALSE(line.strict.isSet());
    EXPECT_FALSE(line.every.isSet());
    EXPECT_EQ(line.every.value(), 7u);
    EXPECT_EQ(line.offset.value(), -2);
    EXPECT_EQ(line.height.value(), 1.25);
    EXPECT_EQ(line.title.value(), "none");
    EXPECT_FALSE(line.title.isSet());
    EXPECT_TRUE(line.set.values().empty());
    EXPECT_FALSE(line.quiet());
}

TEST(CommandLine, valuesFollowOrAreJoinedByAnEqualsSign)
{
    EXPECT_EQ(titleOf({"--title", "a b"}), "a b");
    EXPECT_EQ(titleOf({"--title=a b"}), "a b");
    EXPECT_EQ(titleOf({"--title", "a=b"}), "a=b");
    EXPECT_EQ(titleOf({"--title=a=b"}), "a=b");
    for (const Words& words : {Words{"-o", "x"}, {"--output", "x"}, {"--output=x"}}) {
        Arguments line;
        EXPECT_TRUE(parse(line, words));
        EXPECT_EQ(line.output.value(), "x") << words.front();
    }
}

TEST(CommandLine, aValueMayBeEmptyOrLookLikeAnythingElse)
{
    for (const std::string value : {"", "-", "--", "-x", "--strict", "--title", "--title=", "-o=x",
                                    "[a,b]", "{}", "@file", "/h", "'", "\"a\"", "a,b", "-1", " "})
    {
        EXPECT_EQ(titleOf({"--title", value}), value);
        EXPECT_EQ(titleOf({"--title=" + value, "--every", "3"}), value);
    }
}

TEST(CommandLine, keysMaySetNothingAndComeInTheirOrder)
{
    Arguments line;
    EXPECT_TRUE(parse(line, {"--set", "a.b=", "--strict", "--set=c.d=1", "--set", "[x]"}));
    EXPECT_EQ(line.set.values(), (Words{"a.b=", "c.d=1", "[x]"}));
    EXPECT_TRUE(line.strict.isSet());
}

TEST(CommandLine, pointsMayBeginWithAMinus)
{
    Arguments line;
    EXPECT_TRUE(parse(line, {"--up", "-1,0,0"}));
    EXPECT_EQ(apps::parseDirection(line.up).x, -1);
    Arguments another;
    EXPECT_TRUE(parse(another, {"--up=0,0"}));
    try {
        apps::parsePoint(another.up);
        FAIL();
    } catch (const ConfigurationError& e) {
        EXPECT_STREQ(e.what(), "--up '0,0' is not three numbers like 1.5,-2,0.3");
    }
}

TEST(CommandLine, numbersAreReadInFull)
{
    Arguments line;
    EXPECT_TRUE(parse(line, {"--every", "4294967295", "--offset=-3", "--height", "-.5e1"}));
    EXPECT_EQ(line.every.value(), 4294967295u);
    EXPECT_EQ(line.offset.value(), -3);
    EXPECT_EQ(line.height.value(), -5);
    Arguments padded;
    EXPECT_TRUE(parse(padded, {"--every", " +010 "}));
    EXPECT_EQ(padded.every.value(), 10u);
}

TEST(CommandLine, whatIsNoNumberIsRefused)
{
    for (const std::string text :
         {"x", "", "1.5", "1e3", "0x10", "3 4", "3,4", "nan", "-1", "-0", "--strict"})
        EXPECT_EQ(refusal({"--every", text}),
                  "--every takes a whole number from 0, not '" + text + "' (see --help)");
    EXPECT_EQ(refusal({"--every=-1"}),
              "--every takes a whole number from 0, not '-1' (see --help)");
    EXPECT_EQ(
        refusal({"--every", "4294967296"}),
        "--every takes a whole number from 0 up to 4294967295, not '4294967296' (see --help)");
    EXPECT_EQ(refusal({"--offset", "1.5"}),
              "--offset takes a whole number, not '1.5' (see --help)");
    EXPECT_EQ(refusal({"--offset", "2147483648"}),
              "--offset takes a whole number up to 2147483647, not '2147483648' (see --help)");
    for (const std::string text : {"x", "", "1,5", "nan", "inf", "1e999", "0x1p3", "1.5 m"})
        EXPECT_EQ(refusal({"--height", text}),
                  "--height takes a number, not '" + text + "' (see --help)");
}

TEST(CommandLine, whatMustBeGivenIsNamedTogether)
{
    EXPECT_EQ(refusalOfNeedy({}), "give -i <FILE> and --gt <DIR> and <MAP> (see --help)");
    EXPECT_EQ(refusalOfNeedy({"m", "--gt", "t", "--gt=u"}), "give -i <FILE> (see --help)");
    EXPECT_EQ(refusalOfNeedy({"--gt", "t", "-i", "m"}), "give <MAP> (see --help)");
}

TEST(CommandLine, oneArgumentHasItsPlaceInsteadOfAName)
{
    for (const Words& words : {Words{"m", "-i", "f", "--gt", "t"},
                               {"-i", "f", "--gt", "t", "m"},
                               {"-i", "f", "--gt", "t", "--", "m"}})
    {
        Needy line;
        EXPECT_TRUE(parse(line, words));
        EXPECT_EQ(line.map.value(), "m");
        EXPECT_EQ(line.truths.values(), (Words{"t"}));
    }
    Needy line;
    EXPECT_TRUE(parse(line, {"-i", "f", "--gt", "t", "--", "--strict"}));
    EXPECT_EQ(line.map.value(), "--strict");
    EXPECT_FALSE(line.strict.isSet());
    EXPECT_EQ(refusalOfNeedy({"m", "n"}), "'n' belongs to no option (see --help)");
}

TEST(CommandLine, anOptionWithoutItsValueIsRefused)
{
    EXPECT_EQ(refusal({"--title"}), "--title needs a value (see --help)");
    EXPECT_EQ(refusal({"--strict", "-o"}), "-o needs a value (see --help)");
    EXPECT_EQ(refusal({"--set", "a.b=1", "--set"}), "--set needs a value (see --help)");
}

TEST(CommandLine, aSwitchTakesNoValue)
{
    for (const std::string value : {"", "1", "true", "no"})
        EXPECT_EQ(refusal({"--strict=" + value}), "--strict takes no value (see --help)");
    EXPECT_EQ(refusal({"--strict", "true"}), "'true' belongs to no option (see --help)");
}

TEST(CommandLine, aSwitchOrTextTakesAWordThatIsNoOption)
{
    struct Dumping : Arguments
    {
        apps::SwitchOrText dump{*this, "--dump", "all", "What there is"};
    };
    for (const auto& [words, value] :
         {std::pair(Words{"--dump"}, ""), std::pair(Words{"--dump", "all"}, "all"),
          std::pair(Words{"--dump=all"}, "all"), std::pair(Words{"--dump", "--strict"}, ""),
          std::pair(Words{"--strict", "--dump", "-o", "f"}, "")})
    {
        Dumping line;
        EXPECT_TRUE(parse(line, words));
        EXPECT_TRUE(line.dump.isSet());
        EXPECT_EQ(line.dump.value(), value);
    }
    Dumping without;
    EXPECT_TRUE(parse(without, {"--strict"}));
    EXPECT_FALSE(without.dump.isSet());
    EXPECT_EQ(refusal(without, {"--dump", "all", "more"}),
              "'more' belongs to no option (see --help)");
}

TEST(CommandLine, whatIsGivenTwiceIsRefused)
{
    EXPECT_EQ(refusal({"--title", "a", "--title=a"}), "--title is given twice (see --help)");
    EXPECT_EQ(refusal({"-o", "a", "--output", "b"}), "--output is given twice (see --help)");
    EXPECT_EQ(refusal({"--every", "1", "--every", "x"}), "--every is given twice (see --help)");
    EXPECT_EQ(refusal({"--strict", "--strict"}), "--strict is given twice (see --help)");
    EXPECT_EQ(refusal({"-v", "WARN", "-v", "WARN"}), "--verbosity is given twice (see --help)");
}

TEST(CommandLine, theOptionNearestToAMisspeltOneIsNamed)
{
    EXPECT_EQ(refusal({"--tilte", "a"}),
              "there is no option --tilte, did you mean --title? (see --help)");
    EXPECT_EQ(refusal({"--heigth=3"}),
              "there is no option --heigth, did you mean --height? (see --help)");
    EXPECT_EQ(refusal({"--STRICT"}),
              "there is no option --STRICT, did you mean --strict? (see --help)");
    EXPECT_EQ(refusal({"--outp", "a"}),
              "there is no option --outp, did you mean --output? (see --help)");
    EXPECT_EQ(refusal({"--verb"}),
              "there is no option --verb, did you mean --verbosity? (see --help)");
    EXPECT_EQ(refusal({"--xylophone"}), "there is no option --xylophone (see --help)");
    EXPECT_EQ(refusal({"--zz"}), "there is no option --zz (see --help)");
    EXPECT_EQ(refusalOfNeedy({"--inptu", "f"}),
              "there is no option --inptu, did you mean --input? (see --help)");
}

TEST(CommandLine, shortOptionsAreNotRunTogether)
{
    EXPECT_EQ(refusal({"-ofile"}), "there is no option -ofile (see --help)");
    EXPECT_EQ(refusal({"-o=file"}), "there is no option -o=file (see --help)");
    EXPECT_EQ(refusal({"-output=x"}),
              "there is no option -output=x, did you mean --output? (see --help)");
    EXPECT_EQ(refusal({"-output", "x"}),
              "there is no option -output, did you mean --output? (see --help)");
    EXPECT_EQ(refusal({"-hv"}), "there is no option -hv (see --help)");
    EXPECT_EQ(refusal({"-x"}), "there is no option -x (see --help)");
}

TEST(CommandLine, wordsThatBelongToNothingAreRefused)
{
    for (const std::string word : {"word", "", "-", "@file", "/h", "++"})
        EXPECT_EQ(refusal({word}), "'" + word + "' belongs to no option (see --help)");
    EXPECT_EQ(refusal({"--", "--strict"}), "'--strict' belongs to no option (see --help)");
    EXPECT_EQ(refusal({"--", "--"}), "'--' belongs to no option (see --help)");
    EXPECT_EQ(refusal({"--=3"}), "there is no option --=3 (see --help)");
    EXPECT_EQ(refusal({"--"}), "taken");
}

TEST(CommandLine, verbosityIsOneOfItsLevels)
{
    Arguments line;
    EXPECT_TRUE(parse(line, {"-v", "warn"}));
    EXPECT_TRUE(line.quiet());
    EXPECT_EQ(refusal({"-v", "LOUD"}), "verbosity 'LOUD' is not one of DEBUG, INFO, WARN, ERROR");
    Arguments quiet;
    EXPECT_TRUE(parse(quiet, {"--quiet"}));
    EXPECT_EQ(quiet.verbosity(), mrpt::system::LVL_WARN);
}

TEST(CommandLine, helpShowsTheDescriptionAsItIsAndAllOptions)
{
    const std::string help = printed({"--help"});
    EXPECT_EQ(help, std::string(DESCRIPTION) + R"(

Options:
  -h,  --help
      Displays usage information and exits.
  --version
      Displays version information and exits.
  --quiet
      No progress and no messages but warnings and errors: as -v WARN
  -v <LEVEL>,  --verbosity <LEVEL>
      Least severe messages to show: INFO (notes and progress), WARN or ERROR; DEBUG is for
      MRPT's programs in voxeland-run
  --strict
      What is odd is an error
  --set <section.key=value>  (accepted multiple times)
      Set a key of the configuration; may be repeated
  --every <N>
      Use one in so many
  --offset <N>
      Where to begin
  --height <METRES>
      Above the floor
  --up <X,Y,Z>
      Direction of up
  --title <TEXT>
      Title
  -o <FILE>,  --output <FILE>
      What to write
)");
    EXPECT_EQ(printed({"-h"}), help);
    EXPECT_EQ(printed({"--bogus", "--help"}), help);
    Needy needy;
    testing::internal::CaptureStdout();
    EXPECT_FALSE(parse(needy, {"--help"}));
    const std::string ofNeedy = testing::internal::GetCapturedStdout();
    EXPECT_NE(ofNeedy.find("Options:\n  <MAP>\n      (required)  Map to read\n  -h,  --help\n"),
              std::string::npos);
    EXPECT_NE(ofNeedy.find("  --gt <DIR>  (accepted multiple times)\n      (required)  What is"),
              std::string::npos);
}

TEST(CommandLine, versionIsThatOfTheProject)
{
    EXPECT_EQ(printed({"--version"}), "/usr/bin/program " VOXELAND_VERSION "\n");
}

TEST(CommandLine, aCommandToRunBeginsWithTheFirstWordThatIsNoOption)
{
    const auto wordsOfCommand = [](const Words& words) {
        Arguments line(apps::CommandLine::Rest::command);
        EXPECT_TRUE(parse(line, words));
        return line.wordsOfCommand();
    };
    EXPECT_EQ(wordsOfCommand({"--strict"}), 0u);
    EXPECT_EQ(wordsOfCommand({"run"}), 1u);
    EXPECT_EQ(
        wordsOfCommand({"--strict", "-v", "WARN", "run", "--strict", "-abc", "--bogus=", "--"}),
        5u);
    EXPECT_EQ(wordsOfCommand({"run", "--help"}), 2u);
    EXPECT_EQ(wordsOfCommand({"--", "-run", "x"}), 2u);
    EXPECT_EQ(wordsOfCommand({"--", "run", "--", "x"}), 3u);
    const auto refusalOfCommand = [](const Words& words) {
        Arguments line(apps::CommandLine::Rest::command);
        return refusal(line, words);
    };
    EXPECT_EQ(refusalOfCommand({"--strcit", "run"}),
              "there is no option --strcit, did you mean --strict? (see --help)");
    EXPECT_EQ(refusalOfCommand({"--strict", "--strict", "run"}),
              "--strict is given twice (see --help)");
}

TEST(CommandLine, theCommandIsRepeatedWithOtherValues)
{
    Arguments line;
    EXPECT_TRUE(parse(line, {"--title=a b", "--every", "3", "--strict"}));
    EXPECT_EQ(line.commandWith({{"--every", "4"}, {"--output", "x"}}),
              "/usr/bin/program --title 'a b' --strict --every 4 --output x");
}
