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
 *  \return the file's path
 *  \throws PluginError naming the file, where it was searched, and why it cannot be loaded */
std::string loadPlugin(const std::string& name, const std::vector<std::string>& searchPath);

/** A new object of a plugin class that was loaded or is shipped with Voxeland; of the latter the
 * library is loaded, and no other one ever is.
 *  \param base the base it must have: CLASS_ID(COpinionConverter) or another
 *  \param className with or without "voxeland::"
 *  \throws PluginError, with the classes that exist, if there is none of that name and base */
std::shared_ptr<Plugin> createPlugin(const mrpt::rtti::TRuntimeClassId* base,
                                     const std::string& className);

/** A new object of a class of one library, which is loaded.
 *  \param library as `name` of loadPlugin()
 *  \param className as above; empty: the only one of that base
 *  \throws PluginError as loadPlugin(), or if the library has no such class, with those it has */
std::shared_ptr<Plugin> createPlugin(const mrpt::rtti::TRuntimeClassId* base,
                                     const std::string& className, const std::string& library,
                                     const std::vector<std::string>& searchPath);

/** createPlugin() for a base known to the compiler. */
template <typename Base, typename... Arguments>
std::shared_ptr<Base> createPlugin(const Arguments&... arguments)
{
    return std::dynamic_pointer_cast<Base>(createPlugin(CLASS_ID(Base), arguments...));
}

/** Loads every plugin in the search path and prints all classes by base, each with its library and
 * a line of what it is. */
void listPlugins(std::ostream& out, const std::vector<std::string>& searchPath);
}  // namespace voxeland
