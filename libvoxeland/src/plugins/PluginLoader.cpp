// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/PluginLoader.h"

#include "voxeland/errors.h"
#include "voxeland/joined.h"
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <mrpt/system/os.h>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** What there is, or "none". */
std::string listed(const std::vector<std::string>& words)
{
    return words.empty() ? "none" : joined(words, ", ");
}

/** The file a plugin name stands for, or empty. */
fs::path findPlugin(const std::string& name, const std::vector<std::string>& searchPath)
{
    std::vector<fs::path> folders(searchPath.begin(), searchPath.end());
    if (fs::path(name).is_absolute()) folders = {""};
    for (const fs::path& folder : folders)
        for (const std::string& file : {name, name + ".so"})
            if (fs::is_regular_file(folder / file)) return folder / file;
    return {};
}

std::vector<std::string> classesOf(const mrpt::rtti::TRuntimeClassId* base)
{
    std::vector<std::string> names;
    for (const auto* id : mrpt::rtti::getAllRegisteredClassesChildrenOf(base))
        if (id->ptrCreateObject) names.emplace_back(id->className);
    std::sort(names.begin(), names.end());
    return names;
}
}  // namespace

std::string libraryFile()
{
    Dl_info info;
    if (dladdr(reinterpret_cast<const void*>(&libraryFile), &info) == 0) return {};
    return fs::absolute(info.dli_fname).string();
}

std::vector<std::string> pluginSearchPath(const std::string& iniFolder)
{
    std::vector<std::string> folders;
    if (!iniFolder.empty()) folders.push_back(iniFolder);
    if (const char* variable = std::getenv("VOXELAND_PLUGIN_PATH")) {
        std::istringstream list(variable);
        for (std::string folder; std::getline(list, folder, ':');)
            if (!folder.empty()) folders.push_back(folder);
    }
    folders.push_back((fs::path(libraryFile()).parent_path() / "voxeland").string());
    return folders;
}

void loadPlugin(const std::string& name, const std::vector<std::string>& searchPath)
{
    const fs::path file = findPlugin(name, searchPath);
    if (file.empty())
        throw PluginError("plugin '" + name +
                          "' was not found; searched in: " + listed(searchPath) +
                          " (set VOXELAND_PLUGIN_PATH, or give an absolute path)");
    std::string error;
    if (!mrpt::system::loadPluginModule(fs::absolute(file).string(), error)) {
        std::replace(error.begin(), error.end(), '\n', ' ');
        throw PluginError("'" + file.string() +
                          "' cannot be loaded as a plugin of this Voxeland and "
                          "MRPT " +
                          mrpt::system::MRPT_getVersion() + ": " + error);
    }
}

std::shared_ptr<Plugin> createPlugin(const mrpt::rtti::TRuntimeClassId* base,
                                     const std::string& className)
{
    const auto* id = mrpt::rtti::findRegisteredClass(className, false);
    if (id == nullptr) id = mrpt::rtti::findRegisteredClass("voxeland::" + className, false);
    std::shared_ptr<Plugin> plugin;
    if (id != nullptr && id->derivedFrom(base) && id->ptrCreateObject)
        plugin = std::dynamic_pointer_cast<Plugin>(id->createObject());
    if (!plugin)
        throw PluginError("no loaded plugin has a class '" + className + "' derived from " +
                          base->className + "; there are: " + listed(classesOf(base)));
    return plugin;
}

void listPlugins(std::ostream& out, const std::vector<std::string>& searchPath)
{
    std::set<std::string> seen;
    for (const std::string& folder : searchPath) {
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(folder, ignored)) {
            if (entry.path().extension() != ".so" || !seen.insert(entry.path().filename()).second)
                continue;
            std::string error;
            if (!mrpt::system::loadPluginModule(fs::absolute(entry.path()).string(), error))
                out << entry.path().string() << ": not a plugin of this version\n";
        }
    }
    for (const auto* base :
         {CLASS_ID(COpinionConverter), CLASS_ID(CAssociationPolicy), CLASS_ID(CDisambiguator)})
    {
        out << base->className << ":\n";
        for (const std::string& name : classesOf(base))
            out << "  " << name << "  " << createPlugin(base, name)->description() << "\n";
    }
}
}  // namespace voxeland
