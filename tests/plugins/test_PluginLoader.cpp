// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/PluginLoader.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <sstream>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
const std::string MODULES = VOXELAND_TEST_MODULES;

/** Sets VOXELAND_PLUGIN_PATH while it lives. */
struct PluginPath
{
    explicit PluginPath(const std::string& value)
    {
        setenv("VOXELAND_PLUGIN_PATH", value.c_str(), 1);
    }
    ~PluginPath() { unsetenv("VOXELAND_PLUGIN_PATH"); }
};

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/** The one-sentence message of a PluginError, or "no error". */
template <typename F>
std::string pluginError(F&& f)
{
    try {
        f();
    } catch (const PluginError& e) {
        EXPECT_FALSE(contains(e.what(), "\n")) << e.what();
        return e.what();
    }
    return "no error";
}
}  // namespace

// First: nothing is unloaded that another test of this process loads.
TEST(PluginLoader, OnlyTheLibraryOfTheClassIsLoaded)
{
    const std::string other = pluginSearchPath().back() + "/category_association.so";
    ASSERT_TRUE(fs::exists(other));
    createPlugin<CAssociationPolicy>(std::string("CIoUAssociation"));
    EXPECT_EQ(dlopen(other.c_str(), RTLD_NOW | RTLD_NOLOAD), nullptr);
    createPlugin<CAssociationPolicy>(std::string("CCategoryAssociation"));
    EXPECT_NE(dlopen(other.c_str(), RTLD_NOW | RTLD_NOLOAD), nullptr);
}

TEST(PluginLoader, SearchesTheIniFolderThenTheEnvironmentThenTheLibrarysOwn)
{
    const PluginPath path("/first:/second::");
    const auto folders = pluginSearchPath("/ini");
    ASSERT_EQ(folders.size(), 4u);
    EXPECT_EQ(folders[0], "/ini");
    EXPECT_EQ(folders[1], "/first");
    EXPECT_EQ(folders[2], "/second");
    EXPECT_TRUE(fs::exists(fs::path(folders[3]) / "recorded_instances.so")) << folders[3];
}

TEST(PluginLoader, TheFirstFolderWithTheFileWins)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("test_plugin.so"), "not a library");
    EXPECT_TRUE(contains(pluginError([&] {
                             loadPlugin("test_plugin", {folder.path().string(), MODULES});
                         }),
                         folder.file("test_plugin.so")));
    EXPECT_NO_THROW(loadPlugin("test_plugin", {MODULES, folder.path().string()}));
}

TEST(PluginLoader, APluginIsFoundByItsNameOrPath)
{
    const PluginPath path(MODULES);
    EXPECT_NO_THROW(loadPlugin("test_plugin", pluginSearchPath()));
    EXPECT_NO_THROW(loadPlugin("test_plugin.so", pluginSearchPath()));
    EXPECT_NO_THROW(loadPlugin(MODULES + "/test_plugin.so", {}));
    EXPECT_NO_THROW(loadPlugin(MODULES + "/test_plugin", {}));
}

TEST(PluginLoader, AMissingPluginNamesWhereItWasSearched)
{
    const std::string message = pluginError([] {
        loadPlugin("no_such", {"/one/folder", "/another"});
    });
    for (const char* part : {"'no_such'", "/one/folder", "/another", "VOXELAND_PLUGIN_PATH"})
        EXPECT_TRUE(contains(message, part)) << message;
}

TEST(PluginLoader, ATextFileIsNoPlugin)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("text.so"), "hello\n");
    const std::string message = pluginError([&] { loadPlugin("text", {folder.path().string()}); });
    EXPECT_TRUE(contains(message, folder.file("text.so"))) << message;
    EXPECT_TRUE(contains(message, "MRPT")) << message;
}

TEST(PluginLoader, APluginWithAnUnresolvedSymbolNamesIt)
{
    const std::string message = pluginError([] { loadPlugin("unresolved_plugin", {MODULES}); });
    EXPECT_TRUE(contains(message, "functionOfAnotherVoxeland")) << message;
    EXPECT_TRUE(contains(message, "unresolved_plugin.so")) << message;
}

TEST(PluginLoader, APluginThatEndsTheProgramIsRefused)
{
    for (const auto& [how, what] : {std::pair("abort", "ends the program (Aborted)"),
                                    std::pair("crash", "ends the program (Segmentation fault)"),
                                    std::pair("throw", "throws an exception: no \\x1b[2Jlicence"),
                                    std::pair("throw while loading", "ends the program")})
    {
        setenv("VOXELAND_TEST_ENDING", how, 1);
        const std::string message = pluginError([] { loadPlugin("ending_plugin", {MODULES}); });
        EXPECT_TRUE(contains(message, what)) << message;
        EXPECT_TRUE(contains(message, "ending_plugin.so")) << message;
    }
    unsetenv("VOXELAND_TEST_ENDING");
}

TEST(PluginLoader, APluginThatIsCutOffIsRefusedWhereverItIsCut)
{
    const test::TemporaryFolder folder;
    const std::string whole = test::readFile(MODULES + "/test_plugin.so");
    for (size_t part = 0; part < 20; ++part) {
        test::writeFile(folder.file("cut.so"), whole.substr(0, whole.size() * part / 20));
        const std::string message = pluginError([&] { loadPlugin(folder.file("cut.so"), {}); });
        EXPECT_TRUE(contains(message, "is cut off") || contains(message, "is no shared library"))
            << part << ": " << message;
    }
    std::string other = whole;
    other[18] = 0x28;  // e_machine: ARM
    test::writeFile(folder.file("arm.so"), other);
    const std::string message = pluginError([&] { loadPlugin(folder.file("arm.so"), {}); });
    EXPECT_TRUE(contains(message, "for another kind of machine")) << message;
}

TEST(PluginLoader, ALibraryThatIsNotOursLacksTheClass)
{
    EXPECT_NO_THROW(loadPlugin("foreign_library", {MODULES}));
    Ini ini;
    ini.set("association.plugin=" + MODULES + "/foreign_library.so");
    ini.set("association.class=CForeign");
    EXPECT_TRUE(contains(pluginError([&] { const MapperConfig config(ini); }), "CForeign"));
}

TEST(PluginLoader, AnUnknownClassListsThoseThereAre)
{
    loadPlugin("evidential_association", pluginSearchPath());
    loadPlugin("iou_association", pluginSearchPath());
    const std::string message =
        pluginError([] { createPlugin<CAssociationPolicy>("CEvidentalAssociation"); });
    for (const char* part : {"'CEvidentalAssociation'", "CAssociationPolicy",
                             "CEvidentialAssociation", "CIoUAssociation"})
        EXPECT_TRUE(contains(message, part)) << message;
}

TEST(PluginLoader, AClassOfAnotherBaseOrAnAbstractOneIsRefused)
{
    loadPlugin("evidential_association", pluginSearchPath());
    EXPECT_NE(pluginError([] { createPlugin<COpinionConverter>("CEvidentialAssociation"); }),
              "no error");
    EXPECT_NE(pluginError([] { createPlugin<CAssociationPolicy>("CAssociationPolicy"); }),
              "no error");
    EXPECT_NE(pluginError([] { createPlugin<CAssociationPolicy>("CVoxelandMap"); }), "no error");
    EXPECT_NE(pluginError([] { createPlugin<CAssociationPolicy>(""); }), "no error");
}

TEST(PluginLoader, ThirdPartiesPluginsAreChosenByTheIni)
{
    const PluginPath path(MODULES);
    Ini ini;
    ini.set("association.plugin=test_plugin");
    ini.set("association.class=voxeland::CTestAssociation");
    ini.set("association.patience=7");
    const MapperConfig config(ini);
    EXPECT_EQ(config.association->description(), "a plugin of the tests");
    EXPECT_TRUE(contains(config.text(), "patience = 7"));

    ini.set("association.patiense=7");
    ini.set("association.patience=70");
    try {
        const MapperConfig wrong(ini);
        FAIL() << "accepted";
    } catch (const ConfigurationError& e) {
        EXPECT_TRUE(contains(e.what(), "'patience'")) << e.what();
        EXPECT_TRUE(contains(e.what(), "within 0 and 10")) << e.what();
    }
}

TEST(PluginLoader, AShippedClassIsChosenByItsNameAlone)
{
    const Ini ini = Ini::fromText(
        "[converter]\nclass = voxeland::CPixelLabelsConverter\n"
        "[association]\nclass = CTrackAssociation\n"
        "[disambiguation]\nclass = CReplayDisambiguator\n",
        "my.ini");
    const MapperConfig config(ini);
    const auto nameOf = [](const Plugin& plugin) {
        return std::string(plugin.GetRuntimeClass()->className);
    };
    EXPECT_EQ(nameOf(*config.converter), "voxeland::CPixelLabelsConverter");
    EXPECT_EQ(nameOf(*config.association), "voxeland::CTrackAssociation");
    EXPECT_EQ(nameOf(*config.disambiguator), "voxeland::CReplayDisambiguator");
}

TEST(PluginLoader, ALibraryOfOnesOwnIsNeverLoadedForItsClassAlone)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("own.classes"), "voxeland::COwn\n");
    test::writeFile(folder.file("own.so"), "not a library");
    const PluginPath path(folder.path().string());
    const std::string message =
        pluginError([] { createPlugin<CAssociationPolicy>(std::string("COwn")); });
    EXPECT_TRUE(contains(message, "there is no class 'COwn'")) << message;
    EXPECT_TRUE(contains(message, "'plugin'")) << message;
}

TEST(PluginLoader, WhereLibraryAndClassDisagreeTheMessageNamesBoth)
{
    const auto message = [](const std::string& library, const std::string& className) {
        Ini ini;
        ini.set("association.plugin=" + library);
        ini.set("association.class=" + className);
        return pluginError([&] { const MapperConfig config(ini); });
    };
    EXPECT_EQ(message("iou_association", "CIoUAssociation"), "no error");
    for (const char* part : {"'iou_association'", "'CEvidentialAssociation'", "CIoUAssociation",
                             "needs no key 'plugin'"})
        EXPECT_TRUE(contains(message("iou_association", "CEvidentialAssociation"), part)) << part;
}

TEST(PluginLoader, ALibraryWithOneClassChoosesIt)
{
    Ini ini;
    ini.set("association.plugin=" + MODULES + "/test_plugin.so");
    const MapperConfig config(ini);
    EXPECT_EQ(config.association->description(), "a plugin of the tests");
    EXPECT_EQ(MapperConfig(Ini::fromText(config.text(), "again")).text(), config.text());
}

TEST(PluginLoader, AFolderOfPluginsIsListedWithDescriptions)
{
    std::ostringstream list;
    listPlugins(list, {MODULES, pluginSearchPath().back(), "/no/such/folder"});
    for (const char* part :
         {"CTestAssociation  a plugin of the tests (test_plugin)", "CEvidentialAssociation",
          "CRecordedInstancesConverter", "unresolved_plugin.so: not a plugin"})
        EXPECT_TRUE(contains(list.str(), part)) << list.str();
}
