// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-calibrate, run as a user does, on simulated rooms. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace voxeland;
using test::readFile;

namespace
{
class VoxelandCalibrate : public testing::Test
{
 protected:
    static void SetUpTestSuite()
    {
        s_folder = std::make_unique<test::TemporaryFolder>();
        for (const char* seed : {"1", "2", "3"}) {
            must("voxeland-simulate",
                 {"-o", file("r") + seed + ".rawlog", "--gt", file("gt") + seed, "--seed", seed,
                  "--rooms", "1", "--frames", "60", "--width", "160", "--height", "120",
                  "--detector", "hard", "--quiet"});
            must("rawlog2voxeland", {"-i", file("r") + seed + ".rawlog", "-o",
                                     file("m") + seed + ".voxeland", "--quiet"});
        }
    }
    static void TearDownTestSuite() { s_folder.reset(); }

    static std::string file(const std::string& name) { return s_folder->file(name); }
    static test::ProgramResult must(const std::string& program,
                                    const std::vector<std::string>& arguments)
    {
        auto result = test::runProgram(program, arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return result;
    }
    static test::ProgramResult calibrate(std::vector<std::string> arguments)
    {
        arguments.emplace_back("--quiet");
        return test::runProgram("voxeland-calibrate", arguments);
    }
    static test::ProgramResult learn(const std::string& ini)
    {
        std::vector<std::string> arguments = {"-o", file(ini)};
        for (const char* seed : {"1", "2", "3"})
            arguments.insert(arguments.end(),
                             {"-m", file("m") + seed + ".voxeland", "--gt", file("gt") + seed});
        return calibrate(arguments);
    }

    static std::unique_ptr<test::TemporaryFolder> s_folder;
};
std::unique_ptr<test::TemporaryFolder> VoxelandCalibrate::s_folder;
}  // namespace

TEST_F(VoxelandCalibrate, LearnsAppliesAndUndoes)
{
    const auto learnt = learn("detector.ini");
    ASSERT_EQ(learnt.exitCode, 0) << learnt.errors;
    for (const char* part : {"instances of 3 maps", "cross-validated", "Brier score", "AUROC"})
        EXPECT_NE(learnt.output.find(part), std::string::npos) << learnt.output;
    EXPECT_NE(readFile(file("detector.ini")).find("words = detector.csv"), std::string::npos);
    EXPECT_EQ(readFile(file("detector.csv")).rfind("word,category,probability\n", 0), 0U);

    const std::string plain = readFile(file("m1.voxeland"));
    ASSERT_EQ(calibrate({"--apply", file("detector.ini"), "-m", file("m1.voxeland"), "-o",
                         file("applied.voxeland")})
                  .exitCode,
              0);
    const std::string applied = readFile(file("applied.voxeland"));
    EXPECT_NE(applied, plain);
    must("rawlog2voxeland", {"-i", file("r1.rawlog"), "-o", file("mapped.voxeland"), "-c",
                             file("detector.ini"), "--quiet"});
    EXPECT_EQ(readFile(file("mapped.voxeland")), applied);
    ASSERT_EQ(calibrate({"--undo", "-m", file("applied.voxeland"), "-o", file("undone.voxeland")})
                  .exitCode,
              0);
    EXPECT_EQ(readFile(file("undone.voxeland")), plain);
}

TEST_F(VoxelandCalibrate, LearnsTheSameFromMapsThatAreCalibratedAlready)
{
    ASSERT_EQ(learn("first.ini").exitCode, 0);
    const std::string plain = readFile(file("m1.voxeland"));
    ASSERT_EQ(calibrate({"--apply", file("first.ini"), "-m", file("m1.voxeland"), "-o",
                         file("m1.voxeland")})
                  .exitCode,
              1)
        << "an input is not replaced";
    ASSERT_EQ(calibrate({"--apply", file("first.ini"), "-m", file("m1.voxeland"), "-o",
                         file("other.voxeland")})
                  .exitCode,
              0);
    std::filesystem::rename(file("other.voxeland"), file("m1.voxeland"));
    ASSERT_EQ(learn("second.ini").exitCode, 0);
    EXPECT_EQ(readFile(file("second.csv")), readFile(file("first.csv")));
    test::writeFile(file("m1.voxeland"), plain);
}

TEST_F(VoxelandCalibrate, WrongUsageIsASentence)
{
    const std::string map = file("m1.voxeland"), out = file("out.voxeland");
    test::writeFile(file("empty.ini"), "[map]\n");
    test::writeFile(file("broken.csv"), "word,category,probability\ntv,tv,0.5\n");
    test::writeFile(file("broken.ini"), "[calibration]\nwords = broken.csv\n");
    for (const auto& [arguments, part] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"-m", map, "-o", file("d.ini")}, "--gt"},
             {{"-m", map, "--gt", file("gt1"), "-o", out}, ".ini"},
             {{"--apply", file("empty.ini"), "-m", map, "-o", out}, "[calibration] words"},
             {{"--apply", file("broken.ini"), "-m", map, "-o", out}, "sum to 0.5"},
             {{"--apply", file("broken.ini"), "--undo", "-m", map, "-o", out}, "one of"},
             {{"--undo", "-m", map, "-m", map, "-o", out}, "one -m"}})
    {
        const auto result = calibrate(arguments);
        EXPECT_EQ(result.exitCode, 1) << part;
        EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
}
