// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-disambiguate, run as a user does, on a simulated apartment whose objects
 * have the colour of their category, with a server that looks at the pictures. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "support/VisionServer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

using namespace voxeland;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{
using Words = std::vector<std::string>;

/** A map with uncertain objects, made once. */
class Disambiguate : public testing::Test
{
 protected:
    static void SetUpTestSuite()
    {
        s_folder = new test::TemporaryFolder;
        must("voxeland-simulate",
             {"-o", file("sim.rawlog"), "--gt", file("gt"), "--seed", "22", "--frames", "60",
              "--detector", "realistic", "--paint", "--quiet"});
        must("rawlog2voxeland", {"-i", file("sim.rawlog"), "-o", file("sim.voxeland"), "--quiet"});
    }
    static void TearDownTestSuite()
    {
        delete s_folder;
        s_folder = nullptr;
    }
    void SetUp() override
    {
        for (const char* name : {"out.voxeland", "again.voxeland", "report.json"})
            fs::remove(file(name));
    }

    static std::string file(const std::string& name) { return s_folder->file(name); }
    static test::ProgramResult must(const std::string& program, const Words& arguments)
    {
        const auto result = test::runProgram(program, arguments);
        EXPECT_EQ(result.exitCode, 0) << program << ": " << result.errors;
        return result;
    }
    static test::ProgramResult run(Words more, const std::string& output = "out.voxeland",
                                   const std::string& map = "sim.voxeland")
    {
        Words arguments = {"-m", file(map), "-i", file("sim.rawlog")};
        if (!output.empty()) arguments.insert(arguments.end(), {"-o", file(output)});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::runProgram("voxeland-disambiguate", arguments);
    }
    /** Options that name a server. */
    static Words at(const std::string& url)
    {
        return {"--set", "disambiguation.class=CChatCompletionsDisambiguator",
                "--set", "disambiguation.base_url=" + url,
                "--set", "disambiguation.model=any",
                "--set", "disambiguation.retries=0",
                "--set", "disambiguation.timeout=5"};
    }
    static Words with(Words words, const Words& more)
    {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static json report()
    {
        return json::parse(test::readFile(file("report.json"))).at("questions");
    }
    static size_t decisionsIn(const json& questions)
    {
        size_t n = 0;
        for (const json& q : questions) n += q.contains("decision") ? 1 : 0;
        return n;
    }
    static double ap50(const std::string& map)
    {
        must("voxeland-eval",
             {"-m", file(map), "--gt", file("gt"), "--report", file("eval.json"), "--quiet"});
        return json::parse(test::readFile(file("eval.json")))
            .at("scenes")
            .at(0)
            .at("mean")
            .at("ap50")
            .get<double>();
    }
    static bool sameContent(const std::string& a, const std::string& b)
    {
        return test::readFile(file(a)) == test::readFile(file(b));
    }

    static test::TemporaryFolder* s_folder;
};

test::TemporaryFolder* Disambiguate::s_folder = nullptr;
}  // namespace

TEST_F(Disambiguate, AServerThatSeesRaisesThePrecisionAndUndoTakesAllBack)
{
    const test::VisionServer server;
    const auto result = run(with(at(server.url()), {"--report", file("report.json")}));
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const json questions = report();
    ASSERT_GT(questions.size(), 5U);
    EXPECT_EQ(decisionsIn(questions), questions.size());
    for (const json& q : questions) {
        EXPECT_EQ(q.at("after").at("category"), q.at("decision").at("category"));
        EXPECT_EQ(q.at("decision").at("source"), "voxeland::CChatCompletionsDisambiguator");
        EXPECT_GT(q.at("decision").at("prompt_tokens"), 0);
    }
    EXPECT_GT(ap50("out.voxeland"), ap50("sim.voxeland"));

    const std::string id = std::to_string(questions[0].at("instance").get<int>());
    const auto explained = json::parse(
        must("voxeland-info", {file("out.voxeland"), "--explain", id, "--json"}).output);
    EXPECT_EQ(explained.at("decisions").size(), 1U);
    EXPECT_FALSE(explained.at("views").empty());
    const auto words = must("voxeland-info", {file("out.voxeland"), "--explain", id}).output;
    EXPECT_NE(words.find("The object category is"), std::string::npos) << words;

    EXPECT_EQ(run({"--undo", id}, "again.voxeland", "out.voxeland").exitCode, 0);
    EXPECT_FALSE(sameContent("again.voxeland", "sim.voxeland"));
    EXPECT_EQ(run({"--undo", "all"}, "again.voxeland", "out.voxeland").exitCode, 0);
    EXPECT_TRUE(sameContent("again.voxeland", "sim.voxeland"));
    EXPECT_EQ(run({"--undo", "nobody"}, "again.voxeland", "out.voxeland").exitCode, 1);
}

TEST_F(Disambiguate, ASecondRunGoesOnWhereTheFirstStopped)
{
    const test::VisionServer server;
    const auto all = with(at(server.url()), {"--report", file("report.json")});
    ASSERT_EQ(run(with(all, {"--set", "disambiguation.max_questions=3"})).exitCode, 0);
    const json first = report();
    EXPECT_EQ(first.size(), 3U);
    const auto result = run(all);
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.errors.find("3 decisions"), std::string::npos) << result.errors;
    for (const json& again : report())
        for (const json& q : first) EXPECT_NE(again.at("instance"), q.at("instance"));
    ASSERT_EQ(run(all).exitCode, 0);
    EXPECT_TRUE(report().empty()) << "everything is decided";
}

TEST_F(Disambiguate, APersonIsToldWhereToAnswerAndMayEditTheAnswer)
{
    const std::string folder = file("asked of a person");
    const auto person = [&] {
        return run({"--set", "disambiguation.plugin=replay", "--set",
                    "disambiguation.class=CReplayDisambiguator", "--set",
                    "disambiguation.folder=" + folder, "--set", "disambiguation.max_questions=2",
                    "--report", file("report.json")});
    };
    const auto first = person();
    ASSERT_EQ(first.exitCode, 0) << first.errors;
    for (const std::string& part :
         {std::string("2 questions without an answer"), "'" + folder + "'",
          std::string("answer.txt"), "'disambiguation.folder=" + folder + "'"})
        EXPECT_NE(first.output.find(part), std::string::npos) << part << "\n" << first.output;

    const auto answers = [&] {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder))
            files.push_back(entry.path() / "answer.txt");
        std::sort(files.begin(), files.end());
        return files;
    }();
    ASSERT_EQ(answers.size(), 2U);
    const auto candidate = [](const fs::path& answer, size_t number) {
        return json::parse(test::readFile(answer.parent_path() / "question.json"))
            .at("candidates")
            .at(number)
            .at("category")
            .get<std::string>();
    };
    const auto decided = [&] {
        for (const json& q : report())
            if (answers[0].parent_path().filename().string().rfind(
                    "instance-" + std::to_string(q.at("instance").get<int>()) + "-", 0) == 0)
                return q.at("after").at("category").get<std::string>();
        return std::string("not asked");
    };
    test::writeFile(answers[0], "A " + candidate(answers[0], 1) + ".\n");
    const auto second = person();
    ASSERT_EQ(second.exitCode, 0) << second.errors;
    EXPECT_NE(second.output.find("1 question without an answer"), std::string::npos)
        << second.output;
    EXPECT_EQ(decided(), candidate(answers[0], 1));
    fs::copy_file(file("out.voxeland"), file("again.voxeland"));

    ASSERT_EQ(person().exitCode, 0);
    EXPECT_TRUE(sameContent("again.voxeland", "out.voxeland")) << "nothing new";
    test::writeFile(answers[0], candidate(answers[0], 0) + "\n");
    ASSERT_EQ(person().exitCode, 0);
    EXPECT_EQ(decided(), candidate(answers[0], 0));
    EXPECT_FALSE(sameContent("again.voxeland", "out.voxeland"));

    fs::remove_all(folder);
    fs::remove(file("again.voxeland"));
    fs::copy_file(file("out.voxeland"), file("again.voxeland"));
    ASSERT_EQ(person().exitCode, 0);
    EXPECT_TRUE(sameContent("again.voxeland", "out.voxeland")) << "decisions outlive the folder";
}

TEST_F(Disambiguate, FailuresEndWithOneSentenceAndKeepWhatWasAnswered)
{
    test::VisionServer server;
    ASSERT_EQ(run(with(at(server.url()), {"--set", "disambiguation.max_questions=2"})).exitCode, 0);
    fs::copy_file(file("out.voxeland"), file("again.voxeland"));
    for (const char* behaviour : {"401", "500", "404"}) {
        const auto result = run(at(server.url(behaviour)));
        EXPECT_EQ(result.exitCode, 2) << behaviour;
        EXPECT_NE(result.output.find("what was answered so far is in " + file("out.voxeland") +
                                     ": run the same command again"),
                  std::string::npos)
            << result.output;
        EXPECT_EQ(result.errors.find("voxeland-disambiguate: "),
                  result.errors.rfind("voxeland-dis"))
            << result.errors;
        EXPECT_TRUE(sameContent("again.voxeland", "out.voxeland")) << behaviour;
    }
    const auto wrong =
        run(with(at(server.url("wrong-category")), {"--set", "disambiguation.max_questions=4"}));
    EXPECT_EQ(wrong.exitCode, 0) << wrong.errors;
    EXPECT_NE(wrong.output.find("giraffe"), std::string::npos) << wrong.output;
    EXPECT_TRUE(sameContent("again.voxeland", "out.voxeland"));
    const std::string url = server.url();
    server.stop();
    EXPECT_EQ(run(at(url)).exitCode, 2);
    EXPECT_TRUE(sameContent("again.voxeland", "out.voxeland"));
}

TEST_F(Disambiguate, ADryRunWritesTheQuestionsAndAsksNobody)
{
    const auto result =
        run(with(at("http://127.0.0.1:9/v1"),
                 {"--dry-run", file("dry"), "--set", "disambiguation.max_questions=2", "--set",
                  "disambiguation.prompt_price=10"}),
            "");
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("2 questions"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find(" of fewer than 20 voxels"), std::string::npos) << result.output;
    const json questions = json::parse(test::readFile(file("dry/questions.json")));
    ASSERT_EQ(questions.at("questions").size(), 2U);
    EXPECT_GT(questions.at("estimated_cost"), 0);
    for (const json& q : questions.at("questions")) {
        const fs::path folder = file("dry/" + q.at("folder").get<std::string>());
        EXPECT_TRUE(fs::exists(folder / "prompt.txt"));
        ASSERT_GT(q.at("pictures").size(), 1U);
        for (const json& p : q.at("pictures"))
            EXPECT_TRUE(fs::exists(folder / p.at("file").get<std::string>()));
    }
    EXPECT_FALSE(fs::exists(file("out.voxeland")));
}

TEST_F(Disambiguate, ADryRunThatFailsSaysWhatIsComplete)
{
    const auto dry = [&](const std::string& folder) {
        return run(with(at("http://127.0.0.1:9/v1"),
                        {"--dry-run", file(folder), "--set", "disambiguation.max_questions=2"}),
                   "");
    };
    ASSERT_EQ(dry("dry").exitCode, 0);
    const json questions = json::parse(test::readFile(file("dry/questions.json")))["questions"];
    const std::string first = questions[0]["folder"], second = questions[1]["folder"];
    fs::create_directories(file("again/" + second + "/prompt.txt"));
    const auto result = dry("again");
    EXPECT_EQ(result.exitCode, 5);
    EXPECT_NE(result.errors.find(second + "/prompt.txt"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("; complete: " + first + "\n"), std::string::npos)
        << result.errors;
    fs::create_directories(file("never/" + first + "/prompt.txt"));
    EXPECT_NE(dry("never").errors.find("; no question is complete\n"), std::string::npos);
}

TEST_F(Disambiguate, TheBaselineChangesNoCategory)
{
    const auto result =
        run({"--report", file("report.json"), "--set", "disambiguation.min_voxels=100"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find(" of fewer than 100 voxels"), std::string::npos) << result.output;
    for (const json& q : report())
        EXPECT_EQ(q.at("before").at("category"), q.at("after").at("category"));
}

TEST_F(Disambiguate, WrongUsageAndAnotherRawlogAreSaid)
{
    EXPECT_EQ(run({}, "").exitCode, 1);
    EXPECT_EQ(run({"--set", "disambiguation.parallel=0"}).exitCode, 1);
    EXPECT_EQ(run({"--set", "disambiguation.no_such_key=0"}).exitCode, 1);
    EXPECT_EQ(run({}, "sim.voxeland").exitCode, 1) << "the output would replace the input";
    must("voxeland-simulate", {"-o", file("other.rawlog"), "--gt", file("other"), "--seed", "5",
                               "--frames", "60", "--quiet"});
    const auto result = test::runProgram(
        "voxeland-disambiguate",
        {"-m", file("sim.voxeland"), "-i", file("other.rawlog"), "-o", file("out.voxeland")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.errors.find("not the rawlog the map was made from"), std::string::npos)
        << result.errors;
}
