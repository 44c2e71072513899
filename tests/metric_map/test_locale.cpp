// SPDX-License-Identifier: BSD-3-Clause
/** Files and answers are the same in a process whose numbers have decimal commas. */
#include "answers/AnswersAsText.h"
#include "exporters/GlbFile.h"
#include "exporters/GridFiles.h"
#include "exporters/MapScene.h"
#include "exporters/OctoMapFile.h"
#include "observations/Trajectory.h"
#include "pipeline/TimingLog.h"
#include "support/GermanNumbers.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/exporters/ExportAll.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <gtest/gtest.h>

#include <fstream>

namespace fs = std::filesystem;
using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** A map with numbers above a thousand, and instances of fractions. */
SemanticVoxelMap someMap()
{
    SemanticVoxelMap map = tinyMap();
    for (int x = 0; x < 1500; ++x) addVoxel(map, {x, 20, 1}, {{UNKNOWN_INSTANCE, 1234.5F}});
    return map;
}

/** Everything that is written of a map, and what is read back of written numbers. */
void writeAll(const fs::path& folder)
{
    const SemanticVoxelMap map = someMap();
    const GravityAlignedFrame frame(estimateUp(map));
    const auto file = [&](const char* name) { return (folder / name).string(); };
    WrittenFiles written;
    exportAll(map, folder.string(), written);
    exportGlb(map, frame, file("map.glb"));
    exportScene(map, frame, file("map.3Dscene"));
    exportOctoMap(map, file("map.bt"));
    exportRosMap(sliceOf(map, frame, {}), file("slice.yaml"), written);
    MappingCounts counts;
    counts.frames = 1234;
    writeFile(file("overview.txt"), asText(overviewOf(map, counts)));
    writeFile(file("overview.json"), asJson(map, overviewOf(map, counts)));
    writeFile(file("instances.txt"), asText(listInstances(map), true, true));
    writeFile(file("list.json"), asJson(map, listInstances(map)));

    const MapperConfig config(
        Ini::fromText("[map]\nresolution = 0.025\n[refinement]\nevery = 12345\n", "my.ini"));
    CVoxelandMap whole(config);
    saveMap(whole, file("map.voxeland"));
    writeFile(file("config.ini"), loadMap(file("map.voxeland"))->configText());

    TimingLog timing;
    StageTimes times = {};
    times[static_cast<size_t>(Stage::rays)] = 1.2345678;
    timing.add(times);
    std::ofstream csv(file("timing.csv"));
    timing.writeCsv(csv);
    csv.close();
    std::ofstream summary(file("timing.txt"));
    TimingLog::fromCsv(file("timing.csv")).printSummary(summary);

    writeFile(file("in.tum"), "1000.5 0.25 1234.5 -0.125 0 0 0 1\n1001.5 0.5 0 0 0 0 0 1\n");
    const auto pose =
        Trajectory::fromTumFile(file("in.tum"), 1).poses.at(mrpt::Clock::fromDouble(1000.5));
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->x, 0.25);
    EXPECT_EQ(pose->y, 1234.5);
}
}  // namespace

TEST(Locale, FilesAndAnswersDoNotDependOnIt)
{
    const TemporaryFolder classic, german;
    writeAll(classic.path());
    const GermanNumbers here;
    writeAll(german.path());
    size_t files = 0;
    for (const auto& entry : fs::directory_iterator(classic.path())) {
        if (entry.is_directory()) continue;
        const fs::path name = entry.path().filename();
        EXPECT_TRUE(readFile(german.path() / name) == readFile(entry.path())) << name;
        ++files;
    }
    EXPECT_GE(files, 20U);
    if (!here.isComplete()) GTEST_SKIP() << "C's functions: de_DE is not installed";
}
