// SPDX-License-Identifier: BSD-3-Clause
/** The INIs that are shipped for disambiguation. */
#include "plugins/PluginLoader.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/Ini.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

using namespace voxeland;

namespace
{
constexpr auto SECTION = "disambiguation";

/** A shipped INI with the back-end it names, its keys loaded. */
struct Example
{
    explicit Example(const std::string& file)
        : ini(Ini::fromFile(std::string(VOXELAND_CONFIG_FOLDER) + "/" + file)),
          className(ini.value(SECTION, "class"))
    {
        backend = createPlugin<CDisambiguator>(className);
        options.add("class", className, backend->description());
        if (!ini.value(SECTION, "answer_reliability").empty())
            options.add("answer_reliability", reliability, {0.5, 0.999}, "no key of a back-end");
        backend->declareOptions(options);
        std::vector<std::string> problems;
        options.load(ini, SECTION, problems);
        EXPECT_TRUE(problems.empty()) << file << ": " << problems.front();
    }

    Ini ini;
    std::string className;
    double reliability = 0;
    OptionList options;
    std::shared_ptr<CDisambiguator> backend;
};
}  // namespace

TEST(DisambiguationExamples, theLocalModelNeedsNoKey)
{
    EXPECT_NO_THROW(Example("disambiguate-local.ini").backend->start());
}

TEST(DisambiguationExamples, openAiWantsTheUsualVariable)
{
    const Example example("disambiguate-openai.ini");
    unsetenv("OPENAI_API_KEY");
    EXPECT_THROW(example.backend->start(), ConfigurationError);
    setenv("OPENAI_API_KEY", "none", 1);
    EXPECT_NO_THROW(example.backend->start());
}

TEST(DisambiguationExamples, theOneForOpenAiListsAllKeys)
{
    setenv("OPENAI_API_KEY", "none", 1);  // the name of no variable is not printed
    std::ostringstream printed;
    Example("disambiguate-openai.ini").options.print(printed, SECTION);
    const std::string file =
        test::readFile(std::string(VOXELAND_CONFIG_FOLDER) + "/disambiguate-openai.ini");
    EXPECT_EQ(file.substr(file.find("\n[") + 1), printed.str()) << "renew it with these lines";
}

TEST(DisambiguationExamples, personAndRecordAreReplays)
{
    for (const char* file : {"disambiguate-person.ini", "disambiguate-record.ini"})
        EXPECT_EQ(Example(file).className, "CReplayDisambiguator");
}
