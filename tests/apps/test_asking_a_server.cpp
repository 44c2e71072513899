// SPDX-License-Identifier: BSD-3-Clause
/** voxeland-disambiguate and a server, through all that can go wrong between them. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "support/VisionServer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace voxeland;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{
constexpr auto KEY = "sk-Secret-0123456789", KEY_VARIABLE = "VOXELAND_TEST_KEY";

class AskingAServer : public testing::Test
{
 protected:
    AskingAServer()
    {
        setenv(KEY_VARIABLE, KEY, 1);
        setenv("no_proxy", "127.0.0.1", 1);
        fs::create_directory(m_requests);
    }

    /** Simulates an apartment and maps it. */
    void makeMap(int seed)
    {
        run("voxeland-simulate",
            {"-o", file("s.rawlog"), "--gt", file("truth"), "--seed", std::to_string(seed),
             "--rooms", "1", "--frames", "60", "--width", "320", "--height", "240", "--paint"});
        run("rawlog2voxeland", {"-i", file("s.rawlog"), "-o", file("s.voxeland")});
    }

    /** Asks about s.voxeland, or goes on with what an earlier call wrote to asked.voxeland. */
    test::ProgramResult ask(const std::string& url, const std::vector<std::string>& more = {}) const
    {
        return test::runProgram("voxeland-disambiguate", askArguments(url, more));
    }
    [[nodiscard]] std::vector<std::string> askArguments(const std::string& url,
                                                        const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments = {"-m", file("s.voxeland"),    "-i", file("s.rawlog"),
                                              "-o", file("asked.voxeland")};
        std::vector<std::string> settings = {
            "class=CChatCompletionsDisambiguator",      "base_url=" + url,  "model=m",
            std::string("api_key_env=") + KEY_VARIABLE, "retry_delay=0.01", "retries=1"};
        settings.insert(settings.end(), more.begin(), more.end());
        for (const std::string& setting : settings) {
            arguments.emplace_back("--set");
            arguments.push_back("disambiguation." + setting);
        }
        return arguments;
    }

    [[nodiscard]] double ap50(const std::string& map) const
    {
        run("voxeland-eval",
            {"-m", file(map), "--gt", file("truth"), "--report", file("eval.json")});
        return json::parse(test::readFile(file("eval.json")))["pooled"]["mean"]["ap50"];
    }
    /** How many requests came since the last call. */
    size_t newRequests()
    {
        size_t count = 0;
        for (const auto& entry : fs::directory_iterator(m_requests))
            if (entry.path().extension() == ".json") ++count;
        return count - std::exchange(m_requestsSeen, count);
    }
    static void run(const std::string& program, std::vector<std::string> arguments)
    {
        arguments.emplace_back("--quiet");
        const auto result = test::runProgram(program, arguments);
        ASSERT_EQ(result.exitCode, 0) << program << ": " << result.errors;
    }
    /** The key is in no text and no file, but those of the server. */
    void expectNoKey(const test::ProgramResult& result) const
    {
        EXPECT_EQ((result.output + result.errors).find(KEY), std::string::npos);
        for (const auto& entry : fs::recursive_directory_iterator(m_folder.path()))
            if (entry.is_regular_file() && entry.path().parent_path() != m_requests) {
                EXPECT_EQ(test::readFile(entry.path()).find(KEY), std::string::npos)
                    << entry.path();
            }
    }
    [[nodiscard]] std::string file(const std::string& name) const { return m_folder.file(name); }

    test::TemporaryFolder m_folder;
    fs::path m_requests = m_folder.path() / "requests";
    test::VisionServer m_server{m_requests.string()};
    size_t m_requestsSeen = 0;
};
}  // namespace

TEST_F(AskingAServer, rightAnswersRaiseTheAveragePrecision)
{
    double before = 0, after = 0;
    for (const int seed : {1, 2}) {
        makeMap(seed);
        const auto result = ask(m_server.url());
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        expectNoKey(result);
        const double then = ap50("s.voxeland"), now = ap50("asked.voxeland");
        EXPECT_GE(now, then) << "apartment " << seed;
        before += then;
        after += now;
        fs::remove(file("asked.voxeland"));
    }
    EXPECT_GT(newRequests(), 2U);
    EXPECT_GT(after, before);
}

TEST_F(AskingAServer, failuresEndTheRunWithASentence)
{
    makeMap(1);
    for (const char* behaviour :
         {"401", "404", "429", "500", "503", "garbage", "half", "no-choices", "broken-off", "slow"})
    {
        const auto result =
            ask(m_server.url(behaviour), {"timeout=0.3", "give_up_after=1", "max_questions=3"});
        EXPECT_EQ(result.exitCode, 2) << behaviour << ": " << result.errors;
        EXPECT_NE(result.errors.find(m_server.url(behaviour)), std::string::npos) << result.errors;
        expectNoKey(result);
    }
    const std::string url = m_server.url();
    m_server.stop();
    const auto result = ask(url);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.errors.find("check base_url"), std::string::npos) << result.errors;
}

TEST_F(AskingAServer, aWrongCategoryIsNoDecision)
{
    makeMap(1);
    for (const char* behaviour : {"wrong-category", "several-categories"}) {
        const auto result = ask(m_server.url(behaviour), {"max_attempts=2", "max_questions=1"});
        EXPECT_EQ(newRequests(), 2U) << "attempts";
        EXPECT_NE(result.exitCode, -1) << result.errors;
        EXPECT_EQ(ap50("s.voxeland"), ap50("asked.voxeland"));
    }
}

TEST_F(AskingAServer, aSecondRunGoesOnWhereTheFirstStopped)
{
    makeMap(1);
    const auto first = ask(m_server.url("two-then-401"), {"parallel=1"});
    EXPECT_EQ(first.exitCode, 2) << first.errors;
    EXPECT_EQ(newRequests(), 3U);
    const auto second = ask(m_server.url(), {"parallel=1"});
    EXPECT_EQ(second.exitCode, 0) << second.errors;
    const size_t rest = newRequests();
    EXPECT_GT(rest, 0U);
    fs::rename(file("asked.voxeland"), file("in_two_runs.voxeland"));
    EXPECT_EQ(ask(m_server.url()).exitCode, 0);
    EXPECT_EQ(newRequests(), rest + 2) << "two were not asked again";
    EXPECT_EQ(ap50("in_two_runs.voxeland"), ap50("asked.voxeland"));
}

TEST_F(AskingAServer, aKilledRunLosesAtMostTheQuestionInFlight)
{
    makeMap(1);
    std::string command = std::string(VOXELAND_TEST_BINARY_DIR) + "/bin/voxeland-disambiguate";
    for (const std::string& word : askArguments(m_server.url("leisurely"), {"parallel=1"}))
        command += " '" + word + "'";
    test::runProgram("sh", {"-c", command + " & until [ -e '" + (m_requests / "3.json").string() +
                                      "' ]; do sleep 0.05; done; kill -9 $!"});
    EXPECT_EQ(newRequests(), 3U);
    const auto second = ask(m_server.url(), {"parallel=1"});
    EXPECT_EQ(second.exitCode, 0) << second.errors;
    const size_t rest = newRequests();
    fs::remove(file("asked.voxeland"));
    EXPECT_EQ(ask(m_server.url()).exitCode, 0);
    EXPECT_EQ(newRequests(), rest + 2) << "two of three were answered";
}
