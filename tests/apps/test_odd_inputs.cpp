// SPDX-License-Identifier: BSD-3-Clause
/** Inputs that ended programs by a signal, never, or in words of a library, through the programs.
 */
#include "support/RunProgram.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <set>
#include <sys/stat.h>

using namespace voxeland;

namespace
{
class OddInputs : public testing::Test
{
 protected:
    OddInputs() { test::writeRawlog(rawlog(), test::smallFrames(3), true); }

    [[nodiscard]] std::string file(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] std::string rawlog() const { return file("r.rawlog"); }
    [[nodiscard]] std::string map()
    {
        const std::string name = file("m.voxeland");
        if (!std::filesystem::exists(name))
            test::runProgram("rawlog2voxeland", {"--quiet", "-i", rawlog(), "-o", name});
        return name;
    }
    /** What a program says that must end in one sentence. \param code the exit code it must have */
    static std::string sentenceOf(int code, const std::string& program,
                                  const std::vector<std::string>& arguments)
    {
        const auto result = test::runProgram(program, arguments);
        EXPECT_EQ(result.exitCode, code) << program << ": " << result.errors;
        const std::string start = program + ": ";
        const size_t begin = result.errors.rfind(start);
        if (begin == std::string::npos) return "no sentence: " + result.errors;
        const std::string sentence = result.errors.substr(begin + start.size());
        EXPECT_EQ(sentence.find('\n'), sentence.size() - 1) << sentence;
        EXPECT_LE(sentence.size(), 300u);
        return sentence;
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(OddInputs, aWordMayBeLong)
{
    const std::string word(60000, '0');
    EXPECT_NE(sentenceOf(1, "rawlog2voxeland", {"--check-config", "--set", word})
                  .find("not of the form section.key=value"),
              std::string::npos);
    EXPECT_NE(sentenceOf(1, "rawlog2voxeland", {"--" + word}).find("there is no option"),
              std::string::npos);
    test::writeFile(file("ground_truth.ply"),
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float " + word +
                        "\nend_header\n" + word + "x\n");
    sentenceOf(3, "voxeland-eval", {"-m", map(), "--gt", m_folder.path().string()});
    test::writeFile(file("run.ini"), "[A_" + word + "_voxelandMap_" + word + "]\na = 1\n");
    sentenceOf(1, "voxeland-run", {"icp-slam", file("run.ini"), rawlog()});
}

TEST_F(OddInputs, xmlWithoutAnElementHoldsNoAnnotation)
{
    test::writeFile(file("011.ply"), "ply\n");
    for (const char* xml : {"<!-- only -->", "<?xml version=\"1.0\"?>", ""}) {
        test::writeFile(file("011.xml"), xml);
        EXPECT_NE(sentenceOf(3, "voxeland-eval",
                             {"-m", map(), "--gt", m_folder.path().string(), "--format", "scenenn"})
                      .find(file("011.xml")),
                  std::string::npos)
            << xml;
    }
}

TEST_F(OddInputs, aNumberThatIsNearlyNothingIsRefused)
{
    EXPECT_NE(
        sentenceOf(1, "rawlog2voxeland", {"--check-config", "--set", "map.prior_strength=1e-320"})
            .find("too close to 0"),
        std::string::npos);
}

TEST_F(OddInputs, onlyRegularFilesAreRead)
{
    const std::string pipe = file("pipe.rawlog"), from = map();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    using Command = std::pair<std::string, std::vector<std::string>>;
    const std::string memory = "/proc/self/mem";  // calls itself a regular file
    for (const std::string& odd :
         {pipe, std::string("/dev/zero"), memory, m_folder.path().string()})
        for (const auto& [program, arguments] : std::vector<Command>{
                 {"rawlog2voxeland", {"-i", odd, "-o", file("o.voxeland")}},
                 {"rawlog2voxeland", {"-i", rawlog(), "-o", file("o.voxeland"), "--poses", odd}},
                 {"rawlog2voxeland", {"-i", rawlog(), "-o", file("o.voxeland"), "--resume", odd}},
                 {"voxeland-info", {odd}},
                 {"voxeland-export", {"-m", odd, "--ply", file("o.ply")}},
                 {"voxeland-report", {"-m", odd, "-o", file("o.html")}},
                 {"voxeland-eval", {"-m", odd, "--gt", odd}},
                 {"rawlog-add-instances", {"-i", odd, "--coco", odd, "-o", file("p.rawlog")}},
                 {"rawlog-add-instances", {"-i", rawlog(), "--coco", odd, "-o", file("p.rawlog")}}})
            sentenceOf(3, program, arguments);
    for (const std::string& odd : {pipe, std::string("/dev/zero"), memory}) {
        sentenceOf(1, "rawlog2voxeland", {"--check-config", "-c", odd});
        sentenceOf(1, "voxeland-run", {"icp-slam", odd, rawlog()});
        sentenceOf(3, "voxeland-eval", {"-m", from, "--gt", odd});
        sentenceOf(3, "rgbd2rawlog",
                   {"--format", "scannet", "--input", odd, "--output", "p.rawlog"});
    }
}

TEST_F(OddInputs, anOutputIsAFileOrADevice)
{
    const std::string pipe = file("pipe"), from = map();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_NE(sentenceOf(5, "voxeland-export", {"-m", from, "--ply", pipe}).find("it is a pipe"),
              std::string::npos);
    EXPECT_EQ(test::runProgram("voxeland-export", {"-m", from, "--ply", "/dev/null"}).exitCode, 0);
    const auto shown = test::runProgram("voxeland-export", {"-m", from, "--ply", "/dev/stdout"});
    EXPECT_EQ(shown.exitCode, 0) << shown.errors;
    EXPECT_EQ(shown.output.substr(0, 4), "ply\n");
}

TEST_F(OddInputs, aHeaderMayPromiseAnyNumberOfNothing)
{
    test::writeFile(
        file("ground_truth.ply"),
        "ply\nformat ascii 1.0\nelement nothing 18000000000000000000\nelement vertex 1\n"
        "property float x\nproperty float y\nproperty float z\nproperty int instance\n"
        "property int category\nend_header\n1 1 1 1 7\n");
    test::writeFile(file("categories.csv"), "index,name\n7,cup\n");
    const auto result =
        test::runProgram("voxeland-eval", {"-m", map(), "--gt", m_folder.path().string()});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
}

TEST_F(OddInputs, whatMrptSaysOfAnIniIsSaidInWords)
{
    test::writeFile(file("a.ini"), "[MappingApplication]\na = 1\n");
    const std::string sentence =
        sentenceOf(1, "voxeland-run", {"icp-slam", file("a.ini"), rawlog()});
    EXPECT_EQ(sentence.find("'" + file("a.ini") + "' has no key '"), 0U) << sentence;
    EXPECT_EQ(sentence.find("failIfNotFound"), std::string::npos) << sentence;
    sentenceOf(1, "voxeland-run", {"icp-slam"});
}
