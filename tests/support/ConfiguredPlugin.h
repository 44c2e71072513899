// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/PluginLoader.h"
#include "voxeland/plugins/Ini.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace voxeland::test
{
/** A started object of a plugin class.
 *  \param keys lines of its INI section */
template <typename Base>
std::shared_ptr<Base> configuredPlugin(const std::string& library, const std::string& className,
                                       const std::string& keys)
{
    loadPlugin(library, pluginSearchPath());
    auto object = createPlugin<Base>(className);
    OptionList options;
    object->declareOptions(options);
    std::vector<std::string> problems;
    options.load(Ini::fromText("[s]\n" + keys, "a text"), "s", problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    object->start();
    return object;
}
}  // namespace voxeland::test
