// SPDX-License-Identifier: BSD-3-Clause
/** A map file is data: what its stored configuration may not make programs do. */
#include "support/RunProgram.h"
#include "support/SmallRawlog.h"
#include "support/StoredConfiguration.h"
#include "support/TestFiles.h"
#include "support/VisionServer.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgcodecs.hpp>

#include <cstdlib>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
const std::string MODULES = VOXELAND_TEST_MODULES, SECRET = "sk-Secret-0123456789";

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/** A rawlog, and a map that was made from it. */
class Trust : public testing::Test
{
 protected:
    Trust()
    {
        setenv("VOXELAND_TEST_MARK", file("mark").c_str(), 1);
        setenv("VOXELAND_TEST_SECRET", SECRET.c_str(), 1);
        setenv("no_proxy", "127.0.0.1", 1);
        test::writeRawlog(file("r.rawlog"), test::smallFrames(8), true);
    }

    [[nodiscard]] std::string file(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] bool wasLoaded() const { return fs::exists(file("mark")); }

    [[nodiscard]] test::ProgramResult map(const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments = {"-i", file("r.rawlog"), "-o", file("m.voxeland")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::runProgram("rawlog2voxeland", arguments);
    }
    /** m.voxeland, made by someone who likes it to say this. */
    void forge(const std::string& configuration) const
    {
        const auto mapped = map();
        ASSERT_EQ(mapped.exitCode, 0) << mapped.errors;
        test::forgeConfiguration(file("m.voxeland"), configuration);
    }
    [[nodiscard]] test::ProgramResult resume(const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments = {
            "-i", file("r.rawlog"), "-o", file("n.voxeland"), "--resume", file("m.voxeland")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::runProgram("rawlog2voxeland", arguments);
    }

    test::TemporaryFolder m_folder;
};

/** What an MRPT program makes of its INI. */
mrpt::maps::CMultiMetricMap mapsOf(const std::string& sections)
{
    const mrpt::config::CConfigFileMemory ini("[maps]\nvoxelandMap_count = 1\n" + sections);
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(ini, "maps");
    return mrpt::maps::CMultiMetricMap(definitions);
}

void insertFrame(mrpt::maps::CMetricMap& map)
{
    const auto frame = test::smallFrames(1)[0];
    const mrpt::poses::CPose3D pose(frame.pose->pose.mean);
    map.insertObservation(*frame.instances, pose);
    map.insertObservation(*frame.scan, pose);
}

std::string complaint(const std::function<void()>& action)
{
    try {
        action();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "none";
}
}  // namespace

TEST_F(Trust, AMapDoesNotNameALibrary)
{
    setenv("VOXELAND_PLUGIN_PATH", MODULES.c_str(), 1);
    for (const std::string& library :
         {MODULES + "/marking_plugin.so", std::string("marking_plugin"),
          fs::relative(MODULES).string() + "/marking_plugin.so"})
    {
        const std::string own = "plugin = " + library + "\nclass = CTestAssociation\n";
        forge("[association]\n" + own);
        const auto refused = resume();
        EXPECT_EQ(refused.exitCode, 2) << library;
        for (const char* part : {"'CTestAssociation'", "[association]", "--set", "marking_plugin"})
            EXPECT_TRUE(has(refused.errors, part)) << refused.errors;

        // A class that is there goes on without the library.
        const std::string plugin = "plugin = " + library + "\n";
        forge("[converter]\n" + plugin + "[association]\nclass = CEvidentialAssociation\n" +
              plugin + "[disambiguation]\n" + plugin);
        const auto resumed = resume();
        EXPECT_EQ(resumed.exitCode, 0) << resumed.errors;
        for (const char* section : {"converter", "association"})
            EXPECT_TRUE(has(resumed.errors, std::string("[") + section + "] plugin = "));
        const auto asked = test::runProgram(
            "voxeland-disambiguate",
            {"-m", file("m.voxeland"), "-i", file("r.rawlog"), "--dry-run", file("q")});
        EXPECT_TRUE(has(asked.errors, "[disambiguation] plugin = ")) << asked.errors;
        EXPECT_FALSE(wasLoaded()) << library;
    }
    // But the user may.
    forge("[association]\nplugin = x\nclass = CTestAssociation\npatience = 7\n");
    const auto resumed = resume({"--set", "association.plugin=marking_plugin"});
    EXPECT_EQ(resumed.exitCode, 0) << resumed.errors;
    EXPECT_TRUE(wasLoaded());
    unsetenv("VOXELAND_PLUGIN_PATH");
}

TEST_F(Trust, NorDoesItInAnMrptProgram)
{
    const std::string plugin = MODULES + "/marking_plugin.so";
    forge("[association]\nclass = CTestAssociation\nplugin = " + plugin + "\n");
    const std::string load =
        "[maps_voxelandMap_00_creationOpts]\nload = " + file("m.voxeland") + "\n";
    EXPECT_TRUE(has(complaint([&] { mapsOf(load); }), "'CTestAssociation'"));
    const auto loaded = loadMap(file("m.voxeland"));
    EXPECT_TRUE(has(complaint([&] { insertFrame(*loaded); }), "'CTestAssociation'"));
    EXPECT_FALSE(wasLoaded());

    // The user's own INI may, and what MRPT copies of such a map is not doubted again.
    auto maps = mapsOf(load + "[maps_voxelandMap_00_association]\nplugin = " + plugin + "\n");
    EXPECT_TRUE(wasLoaded());
    auto copy = maps;
    EXPECT_EQ(complaint([&] { insertFrame(copy); }), "none");
}

TEST_F(Trust, AMapNamesNoFilesToOpen)
{
    forge(
        "[converter]\nclass = CDnnConverter\nmodel = /etc/hostname\nlabels = /etc/passwd\n"
        "[voxeland]\npose_source = tum:/etc/passwd\n");
    const auto network = resume();
    EXPECT_EQ(network.exitCode, 1);
    for (const char* part : {"model = '/etc/hostname'", "labels = '/etc/passwd'",
                             "pose_source = 'tum:/etc/passwd'", "--set"})
        EXPECT_TRUE(has(network.errors, part)) << network.errors;

    forge("[voxeland]\npose_source = tum:/etc/passwd\ndepth_sensor_label = camera\n");
    const auto poses = resume();
    EXPECT_EQ(poses.exitCode, 0) << poses.errors;
    EXPECT_TRUE(has(poses.errors, "pose_source")) << poses.errors;
    EXPECT_FALSE(has(poses.errors, "depth_sensor_label")) << poses.errors;
}

TEST_F(Trust, AMapExpandsNothing)
{
    forge(
        "@define KEY $env{VOXELAND_TEST_SECRET}\n[voxeland]\n"
        "depth_sensor_label = $env{VOXELAND_TEST_SECRET}\ninstances_sensor_label = ${KEY}\n"
        "[map]\nprior_strength = $eval{1+2}\nmissed_share = 0.25\n");
    const auto dumped = resume({"--dump-config"});
    EXPECT_EQ(dumped.exitCode, 0) << dumped.errors;
    EXPECT_FALSE(has(dumped.output + dumped.errors, SECRET)) << dumped.output;
    EXPECT_TRUE(has(dumped.output, "missed_share = 0.25")) << dumped.output;
    EXPECT_FALSE(has(dumped.output, "prior_strength = 3")) << dumped.output;
    EXPECT_TRUE(has(dumped.errors, "$env{VOXELAND_TEST_SECRET}")) << dumped.errors;
}

TEST_F(Trust, WhatTheUsersIniExpandsIsNotStored)
{
    test::writeFile(file("own.ini"),
                    "@define KEY $env{VOXELAND_TEST_SECRET}\n@define HALF 0.5\n"
                    "[disambiguation]\nclass = CChatCompletionsDisambiguator\n"
                    "model = ${KEY}\nextra_body = {\"key\": \"$env{VOXELAND_TEST_SECRET}\"}\n"
                    "[map]\nmissed_share = $eval{HALF/2}\n");
    const auto mapped = map({"-c", file("own.ini")});
    ASSERT_EQ(mapped.exitCode, 0) << mapped.errors;
    const std::string content = test::contentOfMap(file("m.voxeland"));
    EXPECT_FALSE(has(content, SECRET));
    EXPECT_TRUE(has(content, "model = $env{VOXELAND_TEST_SECRET}\n"));
    EXPECT_TRUE(has(content, "extra_body = {\"key\": \"$env{VOXELAND_TEST_SECRET}\"}\n"));
    EXPECT_TRUE(has(content, "missed_share = 0.25\n"));
}

TEST_F(Trust, NorIsItShown)
{
    const std::string named = "$env{VOXELAND_TEST_SECRET}";
    for (const std::string& wrong :
         {std::string("[map]\nresolution = @"), std::string("[map]\nentropy = @"),
          std::string("[map]\n@ = 1"), std::string("[@]\na = 1"),
          std::string("[association]\nclass = @"),
          std::string("[association]\nclass = C\nplugin = /no/@.so"),
          std::string("[voxeland]\npose_source = @"),
          std::string("[voxeland]\npose_source = tum:/@"),
          std::string("[voxeland]\ndepth_sensor_label = @"),
          std::string("[map]\nresolution = $eval{@ + }")})
    {
        std::string text = wrong;
        for (size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + 1))
            text.replace(at, 1, named);
        test::writeFile(file("own.ini"), text + "\n");
        const auto refused = map({"-c", file("own.ini")});
        EXPECT_GT(refused.exitCode, 0) << wrong;
        EXPECT_FALSE(has(refused.errors + refused.output, SECRET)) << refused.errors;
        EXPECT_TRUE(has(text, "$eval") || has(refused.errors, named)) << refused.errors;
    }
}

TEST_F(Trust, AskingShowsNothingThatWasExpanded)
{
    const auto simulated = test::runProgram(
        "voxeland-simulate", {"-o", file("r.rawlog"), "--seed", "1", "--rooms", "1", "--frames",
                              "60", "--width", "160", "--height", "120", "--quiet"});
    ASSERT_EQ(simulated.exitCode, 0) << simulated.errors;
    ASSERT_EQ(map().exitCode, 0);
    const auto ask = [&](const std::string& keys) {
        test::writeFile(file("own.ini"),
                        "[disambiguation]\nclass = CChatCompletionsDisambiguator\nretries = 0\n"
                        "entropy_threshold = 0\n" +
                            keys);
        return test::runProgram(
            "voxeland-disambiguate",
            {"-m", file("m.voxeland"), "-i", file("r.rawlog"), "-o", file("asked.voxeland"), "-c",
             file("own.ini"), "--report", file("report.json")});
    };
    const std::string named = "$env{VOXELAND_TEST_SECRET}", model = "model = m\n";
    for (const std::string& wrong :
         {model + "base_url = " + named + "\n", model + "ca_file = /" + named + "\n",
          model + "extra_body = " + named + "\n"})
    {
        const auto refused = ask(wrong);
        EXPECT_EQ(refused.exitCode, 1);
        EXPECT_FALSE(has(refused.errors, SECRET)) << refused.errors;
        EXPECT_TRUE(has(refused.errors, named)) << refused.errors;
    }
    // Nobody listens there: what is wrong is told in the report, too.
    const auto away = ask(model + "base_url = http://127.0.0.1:9/" + named + "\n");
    EXPECT_EQ(away.exitCode, 2) << away.errors;
    const std::string told = away.errors + away.output + test::readFile(file("report.json"));
    EXPECT_FALSE(has(told, SECRET)) << told;
    EXPECT_TRUE(has(test::readFile(file("report.json")), named)) << told;
}

TEST_F(Trust, APasswordInAUrlIsNotShown)
{
    const std::string keys = "class = CChatCompletionsDisambiguator\nmodel = m\nbase_url = ";
    const std::string asText = "https://me:" + SECRET + "@host/v1";
    ASSERT_EQ(map().exitCode, 0);
    for (const std::string& url : {asText, "me:" + SECRET + "@host", "ftp" + asText.substr(5)}) {
        test::writeFile(file("own.ini"), "[disambiguation]\n" + keys + url + "\n");
        std::string told;
        for (const std::vector<std::string>& how :
             {std::vector<std::string>{"-c", file("own.ini")},
              {"-c", file("own.ini"), "--dump-config"},
              {"--set", "disambiguation.class=CChatCompletionsDisambiguator", "--set",
               "disambiguation.base_url=" + url}})
        {
            const auto mapped = map(how);
            EXPECT_EQ(mapped.exitCode, 1);
            EXPECT_TRUE(has(mapped.errors, "base_url = '*@host")) << mapped.errors;
            told += mapped.errors + mapped.output;
        }
        test::forgeConfiguration(file("m.voxeland"), "[disambiguation]\n" + keys + url + "\n");
        const auto asked = test::runProgram(
            "voxeland-disambiguate",
            {"-m", file("m.voxeland"), "-i", file("r.rawlog"), "-o", file("n.voxeland")});
        EXPECT_TRUE(has(asked.errors, "base_url = '*@host")) << asked.errors;
        told += asked.errors + asked.output;
        EXPECT_FALSE(has(told, SECRET)) << told;
    }
}

TEST_F(Trust, AKeyInThePlaceOfItsVariablesNameIsNotShown)
{
    for (const std::string& key : {SECRET, std::string("gsk_Secret0123456789")}) {
        const std::string keys =
            "[disambiguation]\nclass = CChatCompletionsDisambiguator\n"
            "base_url = https://localhost:9/v1\nmodel = m\napi_key_env = " +
            key + "\n";
        test::writeFile(file("own.ini"), keys);
        std::string told;
        for (const std::vector<std::string>& how :
             {std::vector<std::string>{"-c", file("own.ini")},
              {"--set", "disambiguation.class=CChatCompletionsDisambiguator", "--set",
               "disambiguation.api_key_env=" + key},
              {"--set", "disambiguation.api_key=" + key}})
        {
            auto more = how;
            more.insert(more.end(), {"--trace", file("trace")});
            const auto mapped = map(more);
            told += mapped.errors + mapped.output;
            more = how;
            more.emplace_back("--dump-config");
            const auto dumped = map(more);
            told += dumped.errors + dumped.output;
        }
        if (key == SECRET) {
            EXPECT_TRUE(has(told, "the name of an environment variable")) << told;
            ASSERT_EQ(map().exitCode, 0);
        } else {
            told += test::contentOfMap(file("m.voxeland")) + test::readFile(file("trace"));
        }
        const auto asked = test::runProgram("voxeland-disambiguate",
                                            {"-m", file("m.voxeland"), "-i", file("r.rawlog"), "-o",
                                             file("asked.voxeland"), "-c", file("own.ini")});
        EXPECT_EQ(asked.exitCode, 1) << asked.errors;
        EXPECT_TRUE(has(asked.errors, "not the key")) << asked.errors;
        EXPECT_FALSE(has(told + asked.errors + asked.output, key)) << told << asked.errors;
        test::forgeConfiguration(file("m.voxeland"), keys);  // as older versions stored it
        const auto resumed = test::runProgram(
            "voxeland-disambiguate",
            {"-m", file("m.voxeland"), "-i", file("r.rawlog"), "-o", file("n.voxeland")});
        EXPECT_TRUE(has(resumed.errors, "api_key_env = '*'")) << resumed.errors;
        EXPECT_FALSE(has(resumed.errors, key)) << resumed.errors;
    }
}

TEST_F(Trust, NorIsWhatAnMrptProgramExpands)
{
    auto maps = mapsOf(
        "[maps_voxelandMap_00_disambiguation]\nclass = "
        "CChatCompletionsDisambiguator\nmodel = $env{VOXELAND_TEST_SECRET}\n");
    insertFrame(maps);
    saveMap(*maps.mapByClass<CVoxelandMap>(), file("m.voxeland"));
    const std::string content = test::contentOfMap(file("m.voxeland"));
    EXPECT_TRUE(has(content, "class = CChatCompletionsDisambiguator\n"));
    EXPECT_FALSE(has(content, SECRET));
}

TEST_F(Trust, AMapNamesNoServerAndNoKey)
{
    const fs::path requests = m_folder.path() / "requests";
    fs::create_directory(requests);
    const test::VisionServer server(requests.string());
    const auto simulated = test::runProgram(
        "voxeland-simulate", {"-o", file("r.rawlog"), "--seed", "1", "--rooms", "1", "--frames",
                              "60", "--width", "320", "--height", "240", "--paint"});
    ASSERT_EQ(simulated.exitCode, 0) << simulated.errors;
    forge("[disambiguation]\nclass = CChatCompletionsDisambiguator\nbase_url = " + server.url() +
          "\nmodel = $env{VOXELAND_TEST_SECRET}\napi_key_env = VOXELAND_TEST_SECRET\n"
          "extra_body = {\"sent\": true}\nsend_key_unencrypted = true\nca_file = /etc/passwd\n"
          "prompt = /etc/passwd\nretries = 0\n");
    const auto ask = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"-m", file("m.voxeland"),    "-i", file("r.rawlog"),
                                              "-o", file("asked.voxeland")};
        for (const std::string& setting : more)
            arguments.insert(arguments.end(), {"--set", "disambiguation." + setting});
        return test::runProgram("voxeland-disambiguate", arguments);
    };
    const auto refused = ask({});
    EXPECT_EQ(refused.exitCode, 1);
    for (const char* key : {"base_url", "api_key_env", "extra_body", "--set"})
        EXPECT_TRUE(has(refused.errors, key)) << refused.errors;
    EXPECT_TRUE(fs::is_empty(requests));

    const auto asked = ask({"base_url=" + server.url(), "model=m"});
    EXPECT_EQ(asked.exitCode, 0) << asked.errors;
    ASSERT_FALSE(fs::is_empty(requests));
    for (const auto& entry : fs::directory_iterator(requests)) {
        EXPECT_EQ(entry.path().extension(), ".json") << "no key is sent";
        const std::string request = test::readFile(entry.path());
        EXPECT_FALSE(has(request, SECRET) || has(request, "\"sent\"") || has(request, "root:"));
    }
}

namespace
{
/** Frames whose colour image is said to be another file. */
std::vector<test::SmallFrame> framesWithImage(const std::string& file)
{
    auto frames = test::smallFrames(4);
    for (auto& frame : frames) {
        frame.scan->hasIntensityImage = true;
        frame.scan->intensityImage.setExternalStorage(file);
    }
    return frames;
}
}  // namespace

TEST_F(Trust, ARawlogShowsOnlyImagesOfItsFolder)
{
    fs::create_directory(file("r_Images"));
    const cv::Mat grey(48, 64, CV_8UC3, cv::Scalar::all(99));
    for (const char* image : {"secret.png", "r_Images/own.png"})
        ASSERT_TRUE(cv::imwrite(file(image), grey));
    fs::create_symlink(file("secret.png"), file("r_Images/link.png"));
    const auto withImage = [&](const std::string& image,
                               const std::vector<std::string>& more = {}) {
        test::writeRawlog(file("r.rawlog"), framesWithImage(image), true);
        return map(more);
    };
    EXPECT_EQ(withImage("own.png").exitCode, 0);
    EXPECT_EQ(withImage(file("r_Images/own.png")).exitCode, 0);
    for (const std::string& image : {file("secret.png"), std::string("../secret.png"),
                                     std::string("link.png"), std::string("/etc/passwd")})
    {
        const auto refused = withImage(image);
        EXPECT_EQ(refused.exitCode, 3) << image;
        EXPECT_TRUE(has(refused.errors, "--trust-paths")) << refused.errors;
        EXPECT_EQ(withImage(image, {"--trust-paths"}).exitCode, 0) << image;
    }
}

TEST_F(Trust, AnImageHasANameThatAFileCanHave)
{
    for (const auto& [name, why] :
         {std::pair(std::string("ab"), "fewer than 3 characters"),
          std::pair(std::string(5000, 'x'), "too long for the name of a file")})
        for (const std::vector<std::string>& more : {{}, std::vector<std::string>{"--trust-paths"}})
        {
            test::writeRawlog(file("r.rawlog"), framesWithImage(name), true);
            const auto refused = map(more);
            EXPECT_EQ(refused.exitCode, 3);
            EXPECT_TRUE(has(refused.errors, "r.rawlog' names '") && has(refused.errors, why))
                << refused.errors;
        }
}

TEST_F(Trust, ARawlogReadsOnlyDepthsOfItsFolder)
{
    fs::create_directory(file("r_Images"));
    const std::string base = mrpt::img::CImage::getImagesPathBase();
    for (const std::string& name : {std::string("depth.bin"), std::string("../depth.bin")}) {
        auto frames = test::smallFrames(1);
        frames[0].scan->rangeImage_convertToExternalStorage(name, file("r_Images"));
        test::writeRawlog(file("r.rawlog"), frames, true);
        const auto mapped = map();
        EXPECT_EQ(mapped.exitCode, name == "depth.bin" ? 0 : 3) << mapped.errors;
    }
    mrpt::img::CImage::setImagesPathBase(base);
    EXPECT_EQ(map({"--trust-paths"}).exitCode, 0);
}
