// SPDX-License-Identifier: BSD-3-Clause
/** The benchmark of whole maps, run on apartments as small as can be. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
class Benchmark : public testing::Test
{
 protected:
    void SetUp() override
    {
        if (test::runProgram("python3", {"--version"}).exitCode != 0)
            GTEST_SKIP() << "no python3 on this machine";
    }

    [[nodiscard]] test::ProgramResult run(const std::vector<std::string>& options) const
    {
        std::vector<std::string> all = {VOXELAND_BENCHMARK,
                                        "--bin",
                                        std::string(VOXELAND_TEST_BINARY_DIR) + "/bin",
                                        "--work",
                                        work().string(),
                                        "--seeds",
                                        "1,2",
                                        "--frames",
                                        "12",
                                        "--size",
                                        "160x120"};
        all.insert(all.end(), options.begin(), options.end());
        return test::runProgram("python3", all);
    }

    [[nodiscard]] fs::path work() const { return m_folder.path() / "work"; }

 private:
    test::TemporaryFolder m_folder;
};

size_t lines(const std::string& text)
{
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}
}  // namespace

TEST_F(Benchmark, PrintsATableAndWritesTheNumbersOfEachApartment)
{
    const auto result = run({"--only", "iou", "--only", "tracks", "--variant", "coarse", "--set",
                             "map.resolution=0.1"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(lines(result.output), 6U) << result.output;
    EXPECT_NE(result.output.find("100.0 %"), std::string::npos) << "the yardstick's own share";
    for (const auto* name : {"\niou ", "\ntracks ", "\ncoarse "})
        EXPECT_NE(result.output.find(name), std::string::npos) << result.output;
    const std::string table = test::readFile(work() / "results.csv");
    EXPECT_EQ(lines(table), 1U + 3U * (2U + 1U)) << table;
    EXPECT_NE(table.find("\ntracks,seed2,"), std::string::npos) << table;
}

TEST_F(Benchmark, UsesRawlogsAgainThatWereMadeWithTheSameOptions)
{
    ASSERT_EQ(run({"--only", "iou"}).exitCode, 0);
    std::vector<fs::path> rawlogs;
    std::vector<fs::file_time_type> made;
    for (const auto& entry : fs::recursive_directory_iterator(work() / "apartments"))
        if (entry.path().filename() == "apartment.rawlog") {
            rawlogs.push_back(entry.path());
            made.push_back(fs::last_write_time(entry.path()));
        }
    ASSERT_EQ(rawlogs.size(), 2U);
    ASSERT_EQ(run({"--only", "iou"}).exitCode, 0);
    for (size_t i = 0; i < rawlogs.size(); ++i)
        EXPECT_EQ(fs::last_write_time(rawlogs[i]), made[i]) << rawlogs[i];
    ASSERT_EQ(run({"--only", "iou", "--detector", "mild", "--seeds", "1"}).exitCode, 0);
    const fs::directory_iterator folders(work() / "apartments");
    EXPECT_EQ(std::distance(folders, {}), 3);
}

TEST_F(Benchmark, WrongUsageIsOneSentence)
{
    const std::vector<std::vector<std::string>> wrong = {
        {"--seeds", "one"},     {"--frames", "0"},
        {"--size", "large"},    {"--only", "everything"},
        {"--variant", "full"},  {"--set", "map.resolutoin=0.1"},
        {"--bin", "/nowhere"},  {"--variant", "mine", "--set", "map.resolution=-1"},
        {"--detector", "none"}, {"--unheard-of"}};
    for (const auto& options : wrong) {
        const auto result = run(options);
        EXPECT_EQ(result.exitCode, 1) << options.back() << ": " << result.errors;
        EXPECT_EQ(lines(result.errors), 1U) << result.errors;
        EXPECT_EQ(result.output, "");
        EXPECT_FALSE(fs::exists(work()));
    }
}
