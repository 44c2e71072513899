// SPDX-License-Identifier: BSD-3-Clause
/** The table of exporters, by which programs write. */
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"
#include "voxeland/exporters/Exporter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
const Exporter& exporterNamed(const std::string& name)
{
    for (const Exporter& e : exporters())
        if (e.name == name) return e;
    throw std::out_of_range(name);
}
}  // namespace

TEST(Exporters, EachHasItsOwnNameAndSaysWhatItWrites)
{
    std::set<std::string> names;
    for (const Exporter& e : exporters()) {
        EXPECT_TRUE(names.insert(e.name).second) << e.name;
        EXPECT_GT(e.description.size(), 20U) << e.name;
        EXPECT_NE(e.write, nullptr) << e.name;
        EXPECT_EQ(e.writesFolder(), e.endings.empty()) << e.name;
    }
}

TEST(Exporters, TellWhatTheyHaveWritten)
{
    const TemporaryFolder folder;
    for (const Exporter& e : exporters()) {
        const std::string ending = e.endings.empty() ? "" : e.endings.front();
        const std::string output = folder.file(e.name + ending);
        ExportSettings settings;
        settings.heights = HeightRange();
        WrittenFiles written;
        e.write(tinyMap(), settings, output, written);
        ASSERT_FALSE(written.names().empty()) << e.name;
        std::set<std::string> files;
        if (e.writesFolder())
            for (const auto& file : std::filesystem::directory_iterator(output))
                files.insert(file.path().string());
        else
            files = {output};
        if (e.beside != nullptr) files.insert(e.beside(output));
        const auto& names = written.names();
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), files) << e.name;
        for (const std::string& file : names)
            EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
    }
}

TEST(Exporters, AFileNamedLikeThatOfAnotherFormatIsRefused)
{
    EXPECT_NO_THROW(checkEnding(exporterNamed("ply"), "a.PLY"));
    EXPECT_NO_THROW(checkEnding(exporterNamed("ply"), "a.cloud")) << "any other name will do";
    EXPECT_NO_THROW(checkEnding(exporterNamed("points"), "a.3Dscene")) << "two write scenes";
    EXPECT_NO_THROW(checkEnding(exporterNamed("png-dir"), "a.ply")) << "a folder";
    EXPECT_THROW(checkEnding(exporterNamed("scene"), "a.metricmap"), ConfigurationError);
    EXPECT_THROW(checkEnding(exporterNamed("csv"), "a.voxeland"), ConfigurationError);
    try {
        checkEnding(exporterNamed("octomap"), "a.ply");
        FAIL();
    } catch (const ConfigurationError& e) {
        EXPECT_STREQ(e.what(), "--octomap 'a.ply' must end in .bt or .ot, which is what it writes");
    }
}

TEST(Exporters, HeightsAreCountedFromTheFloorAndNoted)
{
    const SemanticVoxelMap map = tinyMap();
    std::vector<std::string> notes;
    ExportSettings settings;
    settings.note = [&](const std::string& text) { notes.push_back(text); };
    const double floor = floorHeight(map, settings.frame);
    const HeightRange own = heightsInFrame(map, settings, {0.1, 1.8});
    EXPECT_DOUBLE_EQ(own.low, floor + 0.1);
    EXPECT_DOUBLE_EQ(own.high, floor + 1.8);
    settings.heights = HeightRange{0.5, 0.6};
    EXPECT_DOUBLE_EQ(heightsInFrame(map, settings, {0.1, 1.8}).low, floor + 0.5);
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0].compare(0, 44, "heights are along (0.000, 0.000, 1.000), fro"), 0)
        << notes[0];
}
