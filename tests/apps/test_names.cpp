// SPDX-License-Identifier: BSD-3-Clause
/** Names that do something to a terminal, a page or a file system, through the programs. */
#include "support/RunProgram.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace voxeland;

namespace
{
const std::string HOSTILE =
    "\x1B[2J\n../../cup</script><b>\xC2\x9B"
    "31m\x7F\xE2\x80\xAE";

/** What a terminal would act upon. */
bool actsOnTerminals(const std::string& text)
{
    const bool controls = std::any_of(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) < ' ' && c != '\n') || c == '\x7F';
    });
    return controls || text.find("\xC2\x9B") != std::string::npos ||
           text.find("\xE2\x80\xAE") != std::string::npos;
}

class Names : public testing::Test
{
 protected:
    Names()
    {
        auto frames = test::smallFrames(6);
        for (auto& frame : frames) {
            frame.instances->instances[0].categories = {{HOSTILE, 1.0F}};
            frame.instances->instances[1].categories = {{std::string(100000, 'x'), 1.0F}};
        }
        test::writeRawlog(m_folder.file("r.rawlog"), frames, true);
        mapped = run("rawlog2voxeland", {"-i", m_folder.file("r.rawlog"), "-o", map()});
    }

    [[nodiscard]] std::string map() const { return m_folder.file("m.voxeland"); }
    [[nodiscard]] static test::ProgramResult run(const std::string& program,
                                                 const std::vector<std::string>& arguments)
    {
        auto result = test::runProgram(program, arguments);
        EXPECT_FALSE(actsOnTerminals(result.output)) << program << ": " << result.output;
        EXPECT_FALSE(actsOnTerminals(result.errors)) << program << ": " << result.errors;
        return result;
    }
    static void expectShortLines(const std::string& text)
    {
        size_t length = 0;
        for (const char c : text) {
            length = c == '\n' ? 0 : length + 1;
            ASSERT_LE(length, 300u) << text.substr(0, 2000);
        }
    }

    test::TemporaryFolder m_folder;
    test::ProgramResult mapped;
};
}  // namespace

TEST_F(Names, AreShownEscapedAndShortened)
{
    EXPECT_EQ(mapped.exitCode, 0) << mapped.errors;
    expectShortLines(mapped.output);
    for (const std::vector<std::string>& question :
         std::vector<std::vector<std::string>>{{}, {"--instances"}, {"--explain", "1"}})
    {
        auto arguments = question;
        arguments.insert(arguments.begin(), map());
        const auto told = run("voxeland-info", arguments);
        EXPECT_EQ(told.exitCode, 0);
        expectShortLines(told.output);
        EXPECT_NE(told.output.find("\\x1b[2J\\n../../cup"), std::string::npos) << told.output;
    }
}

TEST_F(Names, StayAsTheyAreInJson)
{
    const auto told = run("voxeland-info", {map(), "--json"});
    const auto categories = nlohmann::json::parse(told.output)["categories"];
    EXPECT_TRUE(categories.contains(HOSTILE));
    EXPECT_TRUE(categories.contains(std::string(100000, 'x')));
}

TEST_F(Names, MakeNoWayOutOfAFolderOrAPage)
{
    const auto exported =
        run("voxeland-export", {"-m", map(), "--per-instance", m_folder.file("objects")});
    EXPECT_EQ(exported.exitCode, 0) << exported.errors;
    size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.file("objects"))) {
        const std::string name = entry.path().filename().string();
        ++files;
        EXPECT_LE(name.size(), 80U);
        EXPECT_EQ(name.find_first_not_of("0123456789_-abcdefghijklmnopqrstuvwxyz.J"),
                  std::string::npos)
            << name;
    }
    EXPECT_GE(files, 2U);

    const auto reported =
        run("voxeland-report", {"-m", map(), "-o", m_folder.file("page.html"), "--title", HOSTILE});
    EXPECT_EQ(reported.exitCode, 0) << reported.errors;
    const std::string page = test::readFile(m_folder.file("page.html"));
    EXPECT_EQ(page.find("cup</script>"), std::string::npos);
    EXPECT_EQ(page.find("<b>\xC2"), std::string::npos);
    EXPECT_EQ(page.find(std::string(200, 'x')), std::string::npos) << "a name is cut";
}

TEST_F(Names, OfCommandLinesAreShownEscapedAndShortened)
{
    for (const std::string& word : {HOSTILE, std::string(20000, 'x'), "a.b" + HOSTILE + "=1"}) {
        for (const std::vector<std::string>& arguments :
             std::vector<std::vector<std::string>>{{"--check-config", "--set", word},
                                                   {"-i", word, "-o", m_folder.file("x")},
                                                   {"-c", word}})
        {
            const auto result = run("rawlog2voxeland", arguments);
            EXPECT_GT(result.exitCode, 0);
            EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1);
            expectShortLines(result.errors);
        }
    }
}
