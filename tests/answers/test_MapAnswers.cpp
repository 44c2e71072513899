// SPDX-License-Identifier: BSD-3-Clause
#include "answers/AnswersAsText.h"
#include "support/TinyMap.h"
#include "voxeland/answers/MapAnswers.h"
#include "voxeland/base/errors.h"
#include "voxeland/map/CategorySearch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voxeland;
using nlohmann::json;
using voxeland::test::tinyMap;

namespace
{
std::vector<instance_id_t> ids(const std::vector<FoundInstance>& found)
{
    std::vector<instance_id_t> result;
    for (const auto& f : found) result.push_back(f.summary.id);
    return result;
}

/** Adds an instance of one voxel. */
instance_id_t addObject(SemanticVoxelMap& map, const std::string& category, const VoxelCoord& v)
{
    const instance_id_t id = test::addInstance(map, {{category, 1}});
    test::addVoxel(map, v, {{id, 1}});
    return id;
}
}  // namespace

TEST(MapAnswers, overview)
{
    const MapOverview o = overviewOf(tinyMap(), {});
    EXPECT_EQ(o.observedVoxels, 4U);
    EXPECT_EQ(o.occupiedVoxels, 3U);
    EXPECT_EQ(o.instances, 2U);
    EXPECT_EQ(o.categories, (std::map<std::string, unsigned>{{"chair", 1}, {"cup", 1}}));
    EXPECT_NEAR(o.boxMin.x, -0.1, 1e-9);
    EXPECT_NEAR(o.boxMax.x, 0.2, 1e-9);
    EXPECT_NEAR(o.boxMax.z, 0.1, 1e-9);
    const MapOverview nothing = overviewOf(SemanticVoxelMap(), {});
    EXPECT_EQ(nothing.occupiedVoxels, 0U);
    EXPECT_EQ(nothing.boxMax.x, 0);
}

TEST(MapAnswers, theBiggestFirstThenTheSurest)
{
    SemanticVoxelMap map = tinyMap();
    EXPECT_EQ(ids(listInstances(map)), (std::vector<instance_id_t>{2, 1}));
    test::addVoxel(map, {0, 1, 0}, {{1, 1}});
    EXPECT_EQ(ids(listInstances(map)), (std::vector<instance_id_t>{1, 2}));
}

TEST(MapAnswers, findsTheNearestFirstIgnoringCase)
{
    SemanticVoxelMap map = tinyMap();
    const auto far = addObject(map, "Cup", {100, 0, 0}), middle = addObject(map, "cup", {20, 0, 0});
    EXPECT_EQ(ids(findInstances(map, "CUP", {0, 0, 0})),
              (std::vector<instance_id_t>{2, middle, far}));
    const auto fromAfar = findInstances(map, "cup", {11, 0.05, 0.05});
    EXPECT_EQ(ids(fromAfar), (std::vector<instance_id_t>{far, middle, 2}));
    EXPECT_NEAR(fromAfar[0].distance, 11 - 10.05, 1e-9);
    EXPECT_NEAR(fromAfar[1].distance, 11 - 2.05, 1e-9);
}

TEST(MapAnswers, partOfANameWillDoWhereNoNameIsTheSame)
{
    SemanticVoxelMap map = tinyMap();
    const auto desk = addObject(map, "dining table", {50, 0, 0});
    EXPECT_EQ(ids(findInstances(map, "table", {})), std::vector<instance_id_t>{desk});
    const auto table = addObject(map, "table", {60, 0, 0});
    EXPECT_EQ(ids(findInstances(map, "table", {})), std::vector<instance_id_t>{table});
    EXPECT_TRUE(findInstances(map, "", {}).empty());
    EXPECT_TRUE(findInstances(map, "sofa", {}).empty());
}

TEST(MapAnswers, namesAreUnderstoodAsPeopleWriteThem)
{
    for (const auto& [wanted, category] :
         std::vector<std::pair<std::string, std::string>>{{"chairs", "chair"},
                                                          {"Shelves", "shelf"},
                                                          {"shelf", "shelves"},
                                                          {"people", "person"},
                                                          {"mice", "mouse"},
                                                          {"knives", "knife"},
                                                          {"boxes", "box"},
                                                          {"potted plants", "potted plant"},
                                                          {"wine glasses", "wine glass"},
                                                          {"batteries", "battery"}})
        EXPECT_EQ(nameFit(wanted, category), NameFit::plural) << wanted;
    EXPECT_EQ(nameFit("Potted_Plant", "potted plant"), NameFit::same);
    EXPECT_EQ(nameFit(" cell  phone ", "cell-phone"), NameFit::same);
    EXPECT_EQ(nameFit("tables", "dining table"), NameFit::part);
    EXPECT_EQ(nameFit("dining tables", "old dining table set"), NameFit::part);
    EXPECT_EQ(nameFit("chairs", "char"), NameFit::none);
    EXPECT_EQ(nameFit("mouses", "moose"), NameFit::none);
    EXPECT_EQ(nameFit("_", "chair"), NameFit::none);
    SemanticVoxelMap map = tinyMap();
    const auto boxes = addObject(map, "boxes", {50, 0, 0}), box = addObject(map, "box", {60, 0, 0});
    EXPECT_EQ(ids(findInstances(map, "box", {})), std::vector<instance_id_t>{box});
    EXPECT_EQ(ids(findInstances(map, "boxes", {})), std::vector<instance_id_t>{boxes});
}

TEST(MapAnswers, whyThereIsNone)
{
    SemanticVoxelMap map = tinyMap();
    EXPECT_EQ(whyNoneIsFound(map, "chiars"), "no 'chiars' in this map (did you mean 'chair'?)");
    EXPECT_EQ(whyNoneIsFound(map, "elephant"), "no 'elephant' in this map");
    map.categories().add("mouse");
    EXPECT_EQ(whyNoneIsFound(map, "mice"),
              "no object of this map is most probably 'mouse', though it knows that category");
}

/** 2^20 - 1 voxels on each side; blocks alone would be told apart up to 2^23, and a place 2^24 away
 *  would then be taken for one near the origin. */
TEST(MapAnswers, placesOutOfRangeAreAnError)
{
    const SemanticVoxelMap map = tinyMap();
    const double edge = test::TINY_RESOLUTION, end = (1 << 20) * edge;
    EXPECT_FALSE(askPlace(map, {end - edge / 2, 0, 0}).observed);
    EXPECT_FALSE(askPlace(map, {0, 0, 1.5 * edge - end}).observed);
    for (const double far : {end + edge / 2, -end - edge / 2, (1 << 24) * edge + 0.05, 1e300,
                             std::numeric_limits<double>::quiet_NaN()})
        for (const mrpt::math::TPoint3D& p :
             {mrpt::math::TPoint3D(far, 0, 0), {0, far, 0}, {0, 0, far}}) {
            EXPECT_THROW(askPlace(map, p), ConfigurationError) << far;
            EXPECT_THROW(findInstances(map, "cup", p), ConfigurationError) << far;
            EXPECT_EQ(map.occupancyAt(p), UNOBSERVED) << far;
        }
    EXPECT_EQ(map.occupancyAt({0.05, 0.05, 0.05}), map.occupancy({0, 0, 0}));
}

TEST(MapAnswers, aPlaceOnAnObject)
{
    const PlaceAnswer a = askPlace(tinyMap(), {0.01, 0.09, 0.05});
    EXPECT_TRUE(a.observed);
    EXPECT_NEAR(a.center.x, 0.05, 1e-9);
    EXPECT_NEAR(a.occupancy, 0.9, 1e-3);
    ASSERT_EQ(a.instances.size(), 2U);
    EXPECT_EQ(a.instances[0].id, 1U);
    EXPECT_EQ(a.instances[0].category, "chair");
    EXPECT_EQ(a.instances[0].alpha, 10);
    EXPECT_NEAR(a.instances[0].probability, 10.0 / 11, 1e-9);
    EXPECT_EQ(a.instances[1].id, UNKNOWN_INSTANCE);
    EXPECT_EQ(a.instances[1].category, "unknown");
    ASSERT_EQ(a.categories.size(), 3U);
    EXPECT_NEAR(a.categories[0].probability, 5.0 / 11, 1e-9);
    EXPECT_NEAR(a.categories[1].probability, 5.0 / 11, 1e-9);
    EXPECT_EQ(a.categories[2].name, "unknown");
    EXPECT_NEAR(a.categories[2].probability, 1.0 / 11, 1e-9);
    EXPECT_NEAR(a.instanceEntropy, test::H_INSTANCE_10_1, 1e-9);
    EXPECT_NEAR(a.winnerCategoryEntropy, test::H_CATEGORY_2_2, 1e-9);
    EXPECT_NEAR(a.categoryEntropy, test::H_SEMANTIC_SEAT, 1e-6);
    EXPECT_FALSE(a.nearest) << "one is there";
}

TEST(MapAnswers, aPlaceNobodySaw)
{
    const PlaceAnswer a = askPlace(tinyMap(), {50, 50, 50});
    EXPECT_FALSE(a.observed);
    EXPECT_TRUE(a.instances.empty());
    EXPECT_EQ(a.occupancy, 0.5);
    EXPECT_NE(asText(a).find("never observed"), std::string::npos);
}

TEST(MapAnswers, whereThereIsNoObjectTheNearestOneIsNamed)
{
    const SemanticVoxelMap map = tinyMap();
    const auto cup = findInstances(map, "cup", {}).at(0).summary;
    auto place = cup.centroid;  // of its only voxel
    place.x += 0.3;
    place.y += 0.4;
    const PlaceAnswer a = askPlace(map, place);
    ASSERT_TRUE(a.nearest);
    EXPECT_EQ(a.nearest->id, cup.id);
    EXPECT_NEAR(a.nearest->distance, 0.5, 1e-6);
    EXPECT_NE(asText(a).find("nearest object  2 (cup), 0.50 m away"), std::string::npos);
    EXPECT_EQ(json::parse(asJson(a))["nearest"]["category"], "cup");
    EXPECT_FALSE(askPlace(SemanticVoxelMap(), place).nearest) << "there is no object at all";
}

TEST(MapAnswers, textNamesWhatMatters)
{
    const SemanticVoxelMap map = tinyMap();
    const std::string table = asText(listInstances(map), false, false);
    for (const char* word : {"chair", "cup", "0.50", "0.583", "1.00", "0.10x0.10x0.10"})
        EXPECT_NE(table.find(word), std::string::npos) << word << " in\n" << table;
    EXPECT_EQ(table.find("vacuity"), std::string::npos);
    const std::string place = asText(askPlace(map, {0.05, 0.05, 0.05}));
    for (const char* word : {"0.909", "10.00", "chair", "0.935"})
        EXPECT_NE(place.find(word), std::string::npos) << word << " in\n" << place;
    EXPECT_NE(asText(overviewOf(map, {})).find("1 cup"), std::string::npos);
}

/** Eight equally likely categories: five are named. */
TEST(MapAnswers, aPlaceIsToldInItsLikeliestCategories)
{
    SemanticVoxelMap map = tinyMap();
    std::map<std::string, double> beta;
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h"}) beta[name] = 1;
    test::addVoxel(map, {9, 9, 9}, {{test::addInstance(map, beta), 1}});
    const PlaceAnswer answer = askPlace(map, {0.95, 0.95, 0.95});
    EXPECT_EQ(answer.categories.size(), 8U);
    EXPECT_NE(asText(answer).find("and 3 categories less likely"), std::string::npos);
    EXPECT_EQ(asText(askPlace(map, {0.05, 0.05, 0.05})).find("less likely"), std::string::npos);
}

TEST(MapAnswers, whereToLookAgain)
{
    ReobservationTarget cup, region;
    cup.instance = 7;
    cup.category = "cup";
    cup.uncertainty = 1.25;
    cup.voxels = 12;
    CameraPose pose;
    pose.pose = mrpt::poses::CPose3D(1, 2, 3, M_PI / 2, 0, 0);
    pose.yaw = M_PI / 2;
    pose.distance = 1.5;
    pose.visible = 0.75;
    cup.poses = {pose};
    const std::string text = asText(std::vector<ReobservationTarget>{cup, region});
    for (const char* part : {"1.250 nat  7 cup, 12 voxels", "from (1.00, 2.00, 3.00), yaw 90",
                             "75 % visible", "region", "no free place"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    const json all = json::parse(asJson(std::vector<ReobservationTarget>{cup, region}));
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0]["id"], 7);
    const json& matrix = all[0]["poses"][0]["matrix"];
    EXPECT_NEAR(matrix[1][0].get<double>(), 1, 1e-9) << "it looks along y";
    EXPECT_EQ(matrix[0][3], 1);
    EXPECT_EQ(matrix[2][3], 3);
    EXPECT_EQ(matrix[3], (json{0.0, 0.0, 0.0, 1.0}));
    EXPECT_EQ(all[1]["kind"], "region");
    EXPECT_FALSE(all[1].contains("id"));
}

TEST(MapAnswers, theSameAsJson)
{
    const SemanticVoxelMap map = tinyMap();
    MappingCounts counts;
    counts.frames = 7;
    const json overview = json::parse(asJson(map, overviewOf(map, counts)));
    EXPECT_EQ(overview["frames"], 7);
    EXPECT_EQ(overview["occupied_voxels"], 3);
    EXPECT_EQ(overview["categories"], (json{{"chair", 1}, {"cup", 1}}));
    const json found = json::parse(asJson(map, findInstances(map, "cup", {0.15, 0.05, 3.05})));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0]["distance"].get<double>(), 3, 1e-9);
    EXPECT_EQ(found[0]["id"], 2);
    const json place = json::parse(asJson(askPlace(map, {0.05, 0.05, 0.05})));
    EXPECT_EQ(place["instances"][0]["alpha"], 10);
    EXPECT_NEAR(place["uncertainty_semantic"].get<double>(), test::H_SEMANTIC_SEAT, 1e-6);
    EXPECT_NEAR(place["categories"]["unknown"].get<double>(), 1.0 / 11, 1e-9);
    EXPECT_EQ(json::parse(asJson(map, std::vector<FoundInstance>())), json::array());
}
