// SPDX-License-Identifier: BSD-3-Clause
#include "PluginLoader.h"

#include "Trial.h"
#include "files/FolderNames.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/printable.h"
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <mrpt/system/os.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
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

using ClassId = mrpt::rtti::TRuntimeClassId;

/** Path of the library that registered a class. */
std::string libraryOf(const ClassId& id)
{
    Dl_info info;
    return dladdr(&id, &info) == 0 ? std::string() : info.dli_fname;
}

/** The classes of a base that can be created, by name. \param library only those of this file */
std::vector<const ClassId*> classesOf(const ClassId* base, const std::string& library = "")
{
    std::vector<const ClassId*> classes;
    std::error_code ignored;
    for (const auto* id : mrpt::rtti::getAllRegisteredClassesChildrenOf(base))
        if (id->ptrCreateObject &&
            (library.empty() || fs::equivalent(libraryOf(*id), library, ignored)))
            classes.push_back(id);
    std::sort(classes.begin(), classes.end(), [](const ClassId* a, const ClassId* b) {
        return std::string_view(a->className) < b->className;
    });
    return classes;
}

/** A class as users call it. */
std::string shortName(const std::string& className)
{
    const std::string ours = "voxeland::";
    return className.compare(0, ours.size(), ours) == 0 ? className.substr(ours.size()) : className;
}

std::string listed(const std::vector<const ClassId*>& classes)
{
    std::vector<std::string> names;
    for (const ClassId* id : classes) names.push_back(shortName(id->className));
    return listed(names);
}

/** Whether a class is the one that a user calls so. */
bool isCalled(const std::string& className, const std::string& word)
{
    return shortName(className) == shortName(word);
}

/** The one of some classes that a user calls so, or null. */
const ClassId* called(const std::string& word, const std::vector<const ClassId*>& classes)
{
    for (const ClassId* id : classes)
        if (isCalled(id->className, word)) return id;
    return nullptr;
}

/** \throws PluginError if the class throws */
std::shared_ptr<Plugin> newObject(const ClassId* id)
{
    try {
        return std::dynamic_pointer_cast<Plugin>(id->createObject());
    } catch (const std::exception& e) {
        throw PluginError("an object of the class '" + shortName(id->className) + "' of " +
                          libraryOf(*id) + " cannot be made: " + printable(e.what()) +
                          ": correct the plugin");
    }
}

/** Folder of the plugins that are shipped with this library. */
fs::path shippedFolder()
{
    return fs::path(libraryFile()).parent_path() / "voxeland";
}

std::array<const ClassId*, 3> bases()
{
    return {CLASS_ID(COpinionConverter), CLASS_ID(CAssociationPolicy), CLASS_ID(CDisambiguator)};
}

bool isLoaded(const std::string& file)
{
    void* const library = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (library != nullptr) dlclose(library);
    return library != nullptr;
}

/** Loads a library and makes an object of each of its classes, which may end the program. */
void tryOut(const std::string& file)
{
    std::string error;
    if (!mrpt::system::loadPluginModule(file, error)) return;  // loading it here says why
    for (const auto* base : bases())
        for (const ClassId* id : classesOf(base, file)) id->createObject();
}

/** Why a library must not be loaded, or cannot be; empty if it is loaded. Those that are shipped
 * are trusted to load, as long as they are whole.
 *  \param file absolute path */
std::string problemOfLoading(const fs::path& file)
{
    if (isLoaded(file.string())) return {};
    if (const auto problem = libraryProblem(file.string()); !problem.empty())
        return "it " + problem + ": build or copy it again";
    std::error_code ignored;
    if (!fs::equivalent(file.parent_path(), shippedFolder(), ignored))
        if (const auto failure = failureInTrial([&] { tryOut(file.string()); }); !failure.empty())
            return "loading it or making its classes " + failure + ": correct it";
    std::string error;
    if (mrpt::system::loadPluginModule(file.string(), error)) return {};
    std::replace(error.begin(), error.end(), '\n', ' ');
    return error;
}

/** Loads those shipped libraries that list a class of this name; each is accompanied by a file
 * NAME.classes, so that no library is loaded just to be asked. */
void loadShipped(const std::string& className)
{
    const fs::path folder = shippedFolder();
    for (const std::string& name : namesIn(folder.string())) {
        const fs::path file = folder / name;
        if (file.extension() != ".classes") continue;
        std::ifstream list(file);
        for (std::string line; std::getline(list, line);)
            if (isCalled(line, className))
                loadPlugin(fs::path(file).replace_extension(".so").string(), {});
    }
}

/** Loads what can be loaded in some folders. \return the files that cannot */
std::vector<std::string> loadAll(const std::vector<std::string>& folders)
{
    std::set<fs::path> seen;
    std::vector<std::string> refused;
    for (const std::string& folder : folders) {
        for (const std::string& name : namesIn(folder)) {
            const fs::path file = fs::path(folder) / name;
            if (file.extension() != ".so" || !seen.insert(name).second) continue;
            if (!problemOfLoading(fs::absolute(file)).empty()) refused.push_back(file.string());
        }
    }
    return refused;
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
    folders.push_back(shippedFolder().string());
    return folders;
}

std::string loadPlugin(const std::string& name, const std::vector<std::string>& searchPath)
{
    const fs::path file = findPlugin(name, searchPath);
    if (file.empty())
        throw PluginError("plugin '" + name +
                          "' was not found; searched in: " + listed(searchPath) +
                          " (set VOXELAND_PLUGIN_PATH, or give an absolute path)");
    if (const auto problem = problemOfLoading(fs::absolute(file)); !problem.empty())
        throw PluginError("'" + file.string() +
                          "' cannot be loaded as a plugin of this Voxeland and " +
                          mrpt::system::MRPT_getVersion() + ": " + problem);
    return fs::absolute(file).string();
}

std::shared_ptr<Plugin> createPlugin(const ClassId* base, const std::string& className)
{
    if (called(className, classesOf(base)) == nullptr) loadShipped(className);
    if (const ClassId* id = called(className, classesOf(base))) return newObject(id);
    loadAll({shippedFolder().string()});  // for the message
    throw PluginError("there is no class '" + className + "' derived from " +
                      shortName(base->className) + "; there are: " + listed(classesOf(base)) +
                      " (for another one, name its library with the key 'plugin')");
}

std::shared_ptr<Plugin> createPlugin(const ClassId* base, const std::string& className,
                                     const std::string& library,
                                     const std::vector<std::string>& searchPath)
{
    const auto classes = classesOf(base, loadPlugin(library, searchPath));
    if (className.empty() && classes.size() == 1) return newObject(classes[0]);
    if (const ClassId* id = called(className, classes)) return newObject(id);
    throw PluginError("plugin '" + library + "' has " +
                      (className.empty() ? "not just one class" : "no class '" + className + "'") +
                      " derived from " + shortName(base->className) +
                      "; it has: " + listed(classes) +
                      " (a class that is shipped with Voxeland needs no key 'plugin': leave it out "
                      "or empty)");
}

void listPlugins(std::ostream& out, const std::vector<std::string>& searchPath)
{
    for (const std::string& file : loadAll(searchPath))
        out << printable(file, UNCUT) << ": not a plugin of this version\n";
    for (const auto* base : bases()) {
        out << base->className << ":\n";
        for (const ClassId* id : classesOf(base))
            out << "  " << id->className << "  " << newObject(id)->description() << " ("
                << fs::path(libraryOf(*id)).stem().string() << ")\n";
    }
}
}  // namespace voxeland
