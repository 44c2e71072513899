// SPDX-License-Identifier: BSD-3-Clause
#include "support/MapBytes.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

using namespace voxeland;
using mrpt::maps::CMultiMetricMap;
using voxeland::test::SmallFrame;

namespace
{
std::string bytesOf(const CVoxelandMap& map)
{
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << map;
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

std::shared_ptr<CVoxelandMap> readAgain(const CVoxelandMap& map)
{
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    archive << map;
    stream.Seek(0);
    return archive.ReadObject<CVoxelandMap>();
}

void insertScan(mrpt::maps::CMetricMap& map, const SmallFrame& f)
{
    map.insertObservation(*f.scan, f.pose->pose.mean);
}
void insertInstances(mrpt::maps::CMetricMap& map, const SmallFrame& f)
{
    map.insertObservation(*f.instances, f.pose->pose.mean);
}
void insert(mrpt::maps::CMetricMap& map, const SmallFrame& f)
{
    insertScan(map, f);
    insertInstances(map, f);
}

CVoxelandMap mapWith(const std::string& assignment)
{
    Ini ini;
    ini.set(assignment);
    return CVoxelandMap(MapperConfig(ini));
}

/** A map of some frames. */
CVoxelandMap mapOf(int frames)
{
    CVoxelandMap map{MapperConfig()};
    for (const auto& f : test::smallFrames(frames)) insert(map, f);
    return map;
}
}  // namespace

TEST(CVoxelandMap, ScansAndPredictionsMayComeInEitherOrder)
{
    CVoxelandMap a{MapperConfig()}, b{MapperConfig()}, c{MapperConfig()};
    std::vector<SmallFrame> late;
    for (const auto& f : test::smallFrames(8)) {
        insertScan(a, f);
        insertInstances(a, f);
        insertInstances(b, f);
        insertScan(b, f);
        insertScan(c, f);  // predictions two frames later
        late.push_back(f);
        if (late.size() > 2) insertInstances(c, late[late.size() - 3]);
    }
    insertInstances(c, late[6]);
    insertInstances(c, late[7]);
    EXPECT_EQ(a.counts().frames, 8u);
    EXPECT_EQ(a.counts().opinions, 16u);
    EXPECT_EQ(bytesOf(a), bytesOf(b));
    EXPECT_EQ(bytesOf(a), bytesOf(c));
}

TEST(CVoxelandMap, ScansWithoutPredictionsWaitUntilFlushed)
{
    CVoxelandMap map{MapperConfig()};
    const auto frames = test::smallFrames(3);
    for (const auto& f : frames) insertScan(map, f);
    EXPECT_TRUE(map.isEmpty());
    map.flush();
    EXPECT_EQ(map.counts().frames, 3u);
    EXPECT_EQ(map.counts().framesWithoutPredictions, 3u);
    EXPECT_TRUE(map.map().instances().empty());
    EXPECT_FALSE(map.isEmpty());
}

TEST(CVoxelandMap, OtherObservationsAreLeftToOtherMaps)
{
    CVoxelandMap map;
    EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationRobotPose()));
    auto labelled = mapWith("voxeland.depth_sensor_label=another");
    EXPECT_FALSE(labelled.insertObservation(*test::smallFrames(1)[0].scan));
}

TEST(CVoxelandMap, TheFirstCameraMetIsTheOnlyOneAlsoOnceWrittenAndRead)
{
    CVoxelandMap map;
    const auto frames = test::smallFrames(4);
    insert(map, frames[0]);
    frames[1].scan->sensorLabel = frames[3].scan->sensorLabel = "rear";
    EXPECT_FALSE(map.insertObservation(*frames[1].scan));
    CVoxelandMap copy = map;
    const auto read = readAgain(map);
    for (auto* m : {&map, &copy, read.get()}) {
        EXPECT_FALSE(m->insertObservation(*frames[3].scan, frames[3].pose->pose.mean));
        insert(*m, frames[2]);
        EXPECT_EQ(m->counts().frames, 2U);
    }
    EXPECT_EQ(bytesOf(*read), bytesOf(map));
    EXPECT_EQ(bytesOf(copy), bytesOf(map));
    EXPECT_EQ(map.withCamera({}).depth_sensor_label, frames[0].scan->sensorLabel);
    InputOptions other;
    other.depth_sensor_label = "other";
    EXPECT_EQ(map.withCamera(other).depth_sensor_label, "other");
}

TEST(CVoxelandMap, TheFirstCameraMayHaveAnyLabelOrNone)
{
    const auto frames = test::smallFrames(3);
    frames[1].scan->sensorLabel = "other";
    for (const char* label : {"", "front // left", "front\n[map]"}) {
        frames[0].scan->sensorLabel = frames[2].scan->sensorLabel = label;
        CVoxelandMap map;
        insert(map, frames[0]);
        const auto read = readAgain(map);
        for (auto* m : {&map, read.get()}) {
            EXPECT_FALSE(m->insertObservation(*frames[1].scan)) << label;
            EXPECT_TRUE(m->insertObservation(*frames[2].scan)) << label;
        }
    }
}

TEST(CVoxelandMap, ACameraWithoutDepthImagesIsNotTheOneToMap)
{
    CVoxelandMap map;
    const auto frames = test::smallFrames(2);
    frames[0].scan->sensorLabel = "points only";
    frames[0].scan->hasRangeImage = false;
    EXPECT_FALSE(map.insertObservation(*frames[0].scan));
    EXPECT_TRUE(map.insertObservation(*frames[1].scan));
}

TEST(CVoxelandMap, AClearedMapTakesAnyCamera)
{
    CVoxelandMap map;
    const auto frames = test::smallFrames(2);
    insert(map, frames[0]);
    map.clear();
    frames[1].scan->sensorLabel = "after the clearing";
    EXPECT_TRUE(map.insertObservation(*frames[1].scan));
}

TEST(CVoxelandMap, ScansOfAnotherCameraAreToldOnce)
{
    const auto frames = test::smallFrames(3);
    frames[1].scan->sensorLabel = frames[2].scan->sensorLabel = "told once";
    CVoxelandMap map;
    insert(map, frames[0]);
    testing::internal::CaptureStderr();
    map.insertObservation(*frames[1].scan);
    readAgain(map)->insertObservation(*frames[2].scan);
    const std::string told = testing::internal::GetCapturedStderr();
    EXPECT_NE(told.find("'told once'"), std::string::npos) << told;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
}

TEST(CVoxelandMap, ClearEmptiesTheMapAndKeepsItsConfiguration)
{
    auto map = mapWith("voxeland.prediction_wait=0");
    const auto frames = test::smallFrames(2);
    insertScan(map, frames[0]);
    EXPECT_EQ(map.counts().frames, 1u) << "waits for nothing";
    map.clear();
    EXPECT_TRUE(map.isEmpty());
    EXPECT_EQ(map.counts().frames, 0u);
    insertScan(map, frames[1]);
    EXPECT_EQ(map.counts().frames, 1u) << "still waits for nothing";
}

TEST(CVoxelandMap, CopiesAreIndependent)
{
    const CVoxelandMap original = mapOf(3);
    const std::string before = bytesOf(original);
    CVoxelandMap copy = original;
    EXPECT_EQ(bytesOf(copy), before);
    insert(copy, test::smallFrames(4)[3]);
    EXPECT_EQ(copy.counts().frames, 4u);
    EXPECT_EQ(bytesOf(original), before);
    EXPECT_EQ(bytesOf(copy), bytesOf(mapOf(4)));
}

TEST(CVoxelandMap, SerializationKeepsEverythingIncludingWhatWaits)
{
    const auto frames = test::smallFrames(6);
    auto map = mapWith("voxeland.prediction_wait=2");
    for (int i = 0; i < 3; ++i) insert(map, frames[static_cast<size_t>(i)]);
    insertScan(map, frames[3]);

    const auto read = readAgain(map);
    EXPECT_EQ(bytesOf(*read), bytesOf(map));
    ASSERT_FALSE(map.map().instances().empty());
    for (const auto& [id, instance] : map.map().instances())
        EXPECT_EQ(read->map().instance(id).voxels, instance.voxels);
    for (auto* m : {&map, read.get()}) {
        insertScan(*m, frames[4]);
        insertScan(*m, frames[5]);
        EXPECT_EQ(m->counts().frames, 4u) << "frame 3 has waited for two newer ones";
    }
    EXPECT_EQ(bytesOf(*read), bytesOf(map));
}

TEST(CVoxelandMap, FilesKeepEveryByte)
{
    const test::TemporaryFolder folder;
    const CVoxelandMap map = mapOf(4);
    saveMap(map, folder.file("a.voxeland"));
    saveMap(*loadMap(folder.file("a.voxeland")), folder.file("b.voxeland"));
    EXPECT_EQ(test::readFile(folder.file("a.voxeland")), test::readFile(folder.file("b.voxeland")));
    EXPECT_EQ(bytesOf(*loadMap(folder.file("a.voxeland"))), bytesOf(map));
}

TEST(CVoxelandMap, DamagedFilesAreRefused)
{
    const test::TemporaryFolder folder;
    saveMap(mapOf(2), folder.file("a.voxeland"));
    const std::string whole = test::readFile(folder.file("a.voxeland"));
    for (const size_t length : {size_t{0}, size_t{30}, whole.size() / 2, whole.size() - 5}) {
        test::writeFile(folder.file("cut.voxeland"), whole.substr(0, length));
        EXPECT_THROW(loadMap(folder.file("cut.voxeland")), InputError) << length;
    }
    EXPECT_THROW(loadMap(folder.file("missing.voxeland")), InputError);
    EXPECT_THROW(saveMap(mapOf(1), folder.file("no/such/folder.voxeland")), OutputError);
}

TEST(CVoxelandMap, SavesItselfAsMrptsMapsDo)
{
    const test::TemporaryFolder folder;
    CVoxelandMap map{MapperConfig()};
    insertScan(map, test::smallFrames(1)[0]);  // still waits
    map.saveMetricMapRepresentationToFile(folder.file("map"));
    EXPECT_EQ(loadMap(folder.file("map.voxeland"))->counts().frames, 1u);
    EXPECT_TRUE(std::filesystem::exists(folder.file("map.3Dscene")));
    EXPECT_EQ(map.counts().frames, 0u);
}

TEST(CVoxelandMap, SavingLeavesOutAWaitingFrameThatCannotBeMapped)
{
    const test::TemporaryFolder folder;
    CVoxelandMap map{MapperConfig()};
    const auto frames = test::smallFrames(4);
    frames[1].scan->rangeUnits = -1;
    frames[2].scan->hasRangeImage = false;
    for (const auto& f : frames) insertScan(map, f);
    map.saveMetricMapRepresentationToFile(folder.file("map"));
    EXPECT_EQ(loadMap(folder.file("map.voxeland"))->counts().frames, 2u);
    EXPECT_THROW(map.flush(), InputError) << "asked for, it says so";
}

TEST(CVoxelandMap, MapsOfAnotherFormatAreCalledThat)
{
    const test::TemporaryFolder folder;
    const std::string name = "voxeland::CVoxelandMap";
    std::string bytes = bytesOf(mapOf(1));
    ASSERT_EQ(bytes.compare(1, name.size(), name), 0);
    bytes[1 + name.size()] = 0;
    test::writeFile(folder.file("old.voxeland"), bytes);
    try {
        loadMap(folder.file("old.voxeland"));
        FAIL() << "was read";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("another version"), std::string::npos) << e.what();
    }
}

TEST(CVoxelandMap, MapsOfTheFormatBeforeTheCameraAreRead)
{
    auto map = mapWith("voxeland.depth_sensor_label=camera");
    insert(map, test::smallFrames(1)[0]);
    std::string bytes = bytesOf(map);
    bytes[1 + std::string("voxeland::CVoxelandMap").size()] = 2;
    // Whether the camera is known, its label's length, and the one frame with its number.
    bytes.erase(bytes.size() - 18, 17);
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("old.voxeland"), bytes);
    const auto read = loadMap(folder.file("old.voxeland"));
    EXPECT_EQ(test::bytesOf(read->map()), test::bytesOf(map.map()));
    EXPECT_EQ(read->configText(), map.configText());
    EXPECT_EQ(read->counts().frames, 1U);
}

TEST(CVoxelandMap, AnotherResolutionIsRefusedOnceThereAreVoxels)
{
    CVoxelandMap map = mapOf(1);
    Ini ini;
    ini.set("map.resolution=0.1");
    EXPECT_THROW(map.setConfig(MapperConfig(ini)), ConfigurationError);
    Ini other;
    other.set("map.entropy=paper");
    EXPECT_NO_THROW(map.setConfig(MapperConfig(other)));
    EXPECT_EQ(map.map().options().entropy, EntropyMeasure::paper);
}

TEST(CVoxelandMap, ShowsItsOccupiedVoxels)
{
    const CVoxelandMap map = mapOf(2);
    size_t occupied = 0;
    map.map().forEachVoxel(
        [&](const VoxelCoord&, log_odds_t, const VoxelEvidence&) { ++occupied; });
    ASSERT_GT(occupied, 100u);
    EXPECT_EQ(map.getAsSimplePointsMap()->size(), occupied);
    mrpt::opengl::CSetOfObjects objects;
    map.getVisualizationInto(objects);
    EXPECT_FALSE(objects.empty());
    const auto box = objects.getBoundingBox();
    EXPECT_GT(box.max.x, 2.5);
    EXPECT_GT(box.min.x, 0.5) << "nothing is near the origin";
    EXPECT_NE(map.asString().find("2 frames"), std::string::npos) << map.asString();
}

TEST(CVoxelandMap, PointsFollowTheMap)
{
    CVoxelandMap map = mapOf(1);
    const size_t before = map.getAsSimplePointsMap()->size();
    auto frame = test::smallFrames(1)[0];
    frame.pose->pose.mean = mrpt::poses::CPose3D(0, 0, 5, 2, 0, 0);
    frame.scan->timestamp += std::chrono::seconds(1);
    frame.instances->timestamp = frame.scan->timestamp;
    insert(map, frame);
    EXPECT_GT(map.getAsSimplePointsMap()->size(), before);
    map.clear();
    EXPECT_TRUE(map.getAsSimplePointsMap()->empty());
}

TEST(CVoxelandMap, MatchesItselfWhollyAndAMapFarAwayNot)
{
    const CVoxelandMap map = mapOf(2);
    EXPECT_EQ(map.compute3DMatchingRatio(&map, mrpt::poses::CPose3D(), {}), 1);
    EXPECT_EQ(map.compute3DMatchingRatio(&map, mrpt::poses::CPose3D(50, 0, 0, 0, 0, 0), {}), 0);
}

TEST(CVoxelandMap, ObservationsAreLikeliestWhereTheyWereMade)
{
    const CVoxelandMap map = mapOf(3);
    const auto frame = test::smallFrames(2)[1];
    const auto likelihood = [&](const mrpt::poses::CPose3D& error) {
        return map.computeObservationLikelihood(*frame.scan, frame.pose->pose.mean + error);
    };
    ASSERT_TRUE(map.canComputeObservationLikelihood(*frame.scan));
    EXPECT_FALSE(map.canComputeObservationLikelihood(*frame.instances));
    const double atTruth = likelihood({});
    for (const auto& error :
         {mrpt::poses::CPose3D(0.3, 0, 0, 0, 0, 0), mrpt::poses::CPose3D(-0.3, 0, 0, 0, 0, 0),
          mrpt::poses::CPose3D(0, 0, 0, 0.3, 0, 0), mrpt::poses::CPose3D(0, 0, 0, 0, 0.3, 0),
          mrpt::poses::CPose3D(5, 5, 5, 0, 0, 0)})
        EXPECT_GT(atTruth, likelihood(error));
}

namespace
{
CMultiMetricMap multiMap(const std::string& more = "")
{
    const mrpt::config::CConfigFileMemory ini(
        std::string("[maps]\nvoxelandMap_count = 1\n[maps_voxelandMap_00_map]\nresolution = 0.1\n"
                    "[maps_voxelandMap_00_voxeland]\nprediction_wait = 0\n" +
                    more));
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(ini, "maps");
    CMultiMetricMap maps;
    maps.setListOfMaps(definitions);
    return maps;
}
}  // namespace

TEST(CVoxelandMap, MrptsIniMakesOne)
{
    auto maps = multiMap();
    ASSERT_EQ(maps.maps.size(), 1u);
    const auto map = maps.mapByClass<CVoxelandMap>();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->map().resolution(), 0.1);
    insertScan(maps, test::smallFrames(1)[0]);
    EXPECT_EQ(map->counts().frames, 1u);
}

TEST(CVoxelandMap, CopiesOfASetOfMapsKeepTheirOptions)
{
    auto maps = multiMap();
    auto copy = maps;
    insertScan(copy, test::smallFrames(1)[0]);
    const auto map = copy.mapByClass<CVoxelandMap>();
    EXPECT_EQ(map->map().resolution(), 0.1);
    EXPECT_EQ(map->counts().frames, 1u);
    EXPECT_TRUE(maps.mapByClass<CVoxelandMap>()->isEmpty());
}

TEST(CVoxelandMap, AnIniOfItsOwnMayBeNamedAndOverridden)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("own.ini"), "[map]\nresolution = 0.2\nentropy = mean\n");
    const auto maps =
        multiMap("[maps_voxelandMap_00_creationOpts]\nconfig = " + folder.file("own.ini") + "\n");
    const auto& options = maps.mapByClass<CVoxelandMap>()->map().options();
    EXPECT_EQ(options.resolution, 0.1);
    EXPECT_EQ(options.entropy, EntropyMeasure::mean);
    EXPECT_ANY_THROW(multiMap("[maps_voxelandMap_00_refinement]\nevrey = 3\n"));
    EXPECT_ANY_THROW(multiMap("[maps_voxelandMap_00_creationOpts]\nconfig = missing.ini\n"));
}

namespace
{
/** What is wrong with sections, as multiMap() says it. */
std::string complaint(const std::string& sections)
{
    try {
        multiMap(sections);
    } catch (const std::exception& e) {
        return e.what();
    }
    return "none";
}
}  // namespace

TEST(CVoxelandMap, MisspeltKeysAndSectionsOfMrptsIniAreTold)
{
    const std::string creation = "[maps_voxelandMap_00_creationOpts]\n";
    EXPECT_NE(complaint(creation + "lod = x.voxeland\n").find("'load'"), std::string::npos);
    EXPECT_NE(complaint(creation + "confg = my.ini\n").find("'config'"), std::string::npos);
    EXPECT_NE(complaint("[maps_voxelandMap_00_likelihoodOptions]\nsigma_dist = 1\n")
                  .find("[maps_voxelandMap_00_likelihoodOpts]"),
              std::string::npos);
    EXPECT_NE(
        complaint("[maps_voxelandMap_00_mapp]\nresolution = 1\n").find("[maps_voxelandMap_00_map]"),
        std::string::npos);
    EXPECT_EQ(complaint(creation +
                        "enableSaveAs3DObject = false\nenableObservationLikelihood = 1\n"
                        "enableObservationInsertion = true\n[maps_pointsMap_00_other]\nkey = 1\n"),
              "none");
}

TEST(CVoxelandMap, ALoadedMapKeepsItsLikelihoodsOptionsButForThoseNamed)
{
    const test::TemporaryFolder folder;
    CVoxelandMap saved = mapWith("map.resolution=0.1");
    saved.likelihoodOptions.sigma_dist = 0.3;
    saved.likelihoodOptions.max_points = 7;
    saveMap(saved, folder.file("saved.voxeland"));
    test::writeFile(folder.file("own.ini"), "[map]\nresolution = 0.1\n");
    const std::string load =
        "[maps_voxelandMap_00_creationOpts]\nload = " + folder.file("saved.voxeland") + "\n";
    const std::string own = "config = " + folder.file("own.ini") + "\n";
    for (const std::string& sections : {load, load + own}) {
        const auto maps = multiMap(sections);
        EXPECT_EQ(maps.mapByClass<CVoxelandMap>()->likelihoodOptions.sigma_dist, 0.3);
    }
    const auto maps = multiMap(load + "[maps_voxelandMap_00_likelihoodOpts]\nmax_points = 9\n");
    const auto& options = maps.mapByClass<CVoxelandMap>()->likelihoodOptions;
    EXPECT_EQ(options.sigma_dist, 0.3);
    EXPECT_EQ(options.max_points, 9u);
}

TEST(CVoxelandMap, LikelihoodsThatLookTooFarForTheResolutionAreRefusedAtOnce)
{
    const std::string section = "[maps_voxelandMap_00_likelihoodOpts]\nmax_corr_distance = ";
    EXPECT_EQ(complaint(section + "9.8\n"), "none") << "98 voxels of 0.1 m";
    EXPECT_NE(complaint(section + "10\n").find("99 voxels"), std::string::npos);
}

TEST(CVoxelandMap, ADefinitionTellsTheMapItBeginsWith)
{
    const test::TemporaryFolder folder;
    saveMap(mapOf(1), folder.file("saved.voxeland"));
    const mrpt::config::CConfigFileMemory ini(
        "[maps]\nvoxelandMap_count = 1\n"
        "[maps_voxelandMap_00_creationOpts]\nload = " +
        folder.file("saved.voxeland") + "\n");
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(ini, "maps");
    std::ostringstream text;
    (*definitions.begin())->dumpToTextStream(text);
    EXPECT_NE(text.str().find("load = " + folder.file("saved.voxeland")), std::string::npos);
}
