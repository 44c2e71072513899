// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/Plugin.h"

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace voxeland
{
/** Path of the file this library was loaded from. */
std::string libraryFile();

/** Folders where plugins are looked for, first to last: that of the INI, those of the environment
 * variable VOXELAND_PLUGIN_PATH (separated by ':'), and `voxeland` beside this library, installed
 * or in its build tree. \param iniFolder empty: there is no INI */
std::vector<std::string> pluginSearchPath(const std::string& iniFolder = "");

/** Loads a plugin library; nothing is ever unloaded, loading twice does nothing.
 *  \param name absolute path, or a file name with or without ".so", looked for in `searchPath`
 *  \throws PluginError naming the file, where it was searched, and why it cannot be loaded */
void loadPlugin(const std::string& name, const std::vector<std::string>& searchPath);

/** A new object of a registered plugin class.
 *  \param base the base it must have: CLASS_ID(COpinionConverter) or another
 *  \param className with or without "voxeland::"
 *  \throws PluginError, with the classes that exist, if there is none of that name and base */
std::shared_ptr<Plugin> createPlugin(const mrpt::rtti::TRuntimeClassId* base,
                                     const std::string& className);

/** createPlugin() for a base known to the compiler. */
template <typename Base>
std::shared_ptr<Base> createPlugin(const std::string& className)
{
    return std::dynamic_pointer_cast<Base>(createPlugin(CLASS_ID(Base), className));
}

/** Loads every plugin in the search path and prints all classes by base, with a line each. */
void listPlugins(std::ostream& out, const std::vector<std::string>& searchPath);
}  // namespace voxeland
