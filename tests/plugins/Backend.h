// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/PluginLoader.h"
#include "voxeland/base/trimmed.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/Ini.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <memory>
#include <sstream>
#include <string>

namespace voxeland::test
{
/** An INI's section [disambiguation] of lines "key = value"; a later one replaces an earlier one.
 */
inline Ini disambiguationIni(const std::string& keys)
{
    Ini ini = Ini::fromText("[disambiguation]\n", "a text");
    std::istringstream lines(keys);
    for (std::string line; std::getline(lines, line);) {
        const size_t equals = line.find('=');
        ini.set("disambiguation." + trimmed(line.substr(0, equals)) + "=" +
                trimmed(line.substr(equals + 1)));
    }
    return ini;
}

/** A disambiguation back-end loaded as users load it, with these INI lines as its keys. */
inline std::shared_ptr<CDisambiguator> backend(const std::string& library,
                                               const std::string& className,
                                               const std::string& keys)
{
    loadPlugin(library, pluginSearchPath());
    auto object = createPlugin<CDisambiguator>(className);
    OptionList options;
    object->declareOptions(options);
    std::vector<std::string> problems;
    options.load(disambiguationIni(keys), "disambiguation", problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    object->start();
    return object;
}

/** An encoded picture of one colour. \param colour blue, green, red */
inline std::string picture(const cv::Scalar& colour, int width, int height,
                           const std::string& extension = ".png")
{
    std::vector<uchar> file;
    cv::imencode(extension, cv::Mat(height, width, CV_8UC3, colour), file);
    return {file.begin(), file.end()};
}

/** Is it a couch or a chair? */
inline DisambiguationQuestion couchOrChair(const cv::Scalar& colour = {20, 20, 20})
{
    DisambiguationQuestion question;
    question.instance = 7;
    question.candidates = {{0, "couch", 0.6}, {1, "chair", 0.4}};
    question.prompt = "Is it a couch or a chair? Answer: The object category is X.";
    question.pictures = {{"from the left", "image/png", picture(colour, 40, 30)},
                         {"from the right", "image/jpeg", picture(colour, 40, 30, ".jpg")}};
    return question;
}
}  // namespace voxeland::test
