// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/MatchedPredictions.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voxeland;
using nlohmann::json;

namespace
{
/** Only row 1 of column 0 of a 2x2 image is set (see test_CocoMasks). */
const json MASK = {{"size", {2, 2}}, {"counts", "112"}};

/** The only category of prediction(). */
const CategoryNames CHAIR = {{62, "chair"}};

json prediction(const json& changes = json::object())
{
    json p = {{"image_id", 3}, {"category_id", 62}, {"score", 0.5}, {"segmentation", MASK}};
    p.update(changes);
    for (const auto& [key, value] : changes.items())
        if (value.is_null()) p.erase(key);
    return p;
}

/** Frames 0 to n-1, without names. */
std::vector<DatasetFrame> frames(int64_t n)
{
    std::vector<DatasetFrame> all;
    for (int64_t i = 0; i < n; ++i) all.push_back({i, ""});
    return all;
}

/** Instances of a frame among ten. */
std::vector<InstancePrediction> instancesOf(const CocoPredictions& predictions, size_t frame)
{
    return MatchedPredictions(predictions, frames(10)).instancesFor(frame, 2, 2)->instances;
}

class CocoPredictionsTest : public testing::Test
{
 protected:
    CocoPredictions load(const json& root, const CategoryNames& names = {},
                         bool strict = false) const
    {
        return loadText(root.dump(), names, strict);
    }
    CocoPredictions loadText(const std::string& text, const CategoryNames& names = {},
                             bool strict = false) const
    {
        test::writeFile(m_file, text);
        return CocoPredictions(m_file, names, strict);
    }
    /** The only prediction of the file, in frame 3 of 2x2 pixels. */
    InstancePrediction only(const json& p, const CategoryNames& names = {}) const
    {
        return instancesOf(load(json::array({p}), names), 3).at(0);
    }
    /** What the constructor says about a text. */
    std::string complaint(const std::string& text) const
    {
        try {
            loadText(text);
        } catch (const InputError& e) {
            const std::string what = e.what();
            return what.substr(what.find(m_file) + m_file.size());
        }
        return "";
    }
    std::string complaint(const json& p) const { return complaint(json::array({p}).dump()); }

    test::TemporaryFolder m_folder;
    std::string m_file = m_folder.file("coco.json");
};

using Bitmap = std::vector<uint8_t>;
}  // namespace

TEST_F(CocoPredictionsTest, readsAPrediction)
{
    const auto p = only(prediction({{"bbox", {0.4, 1.2, 1.1, 0.5}}, {"track_id", 9}}));
    EXPECT_EQ(p.categories, (CategoryDistribution{{"chair", 1.0F}}));
    EXPECT_EQ(p.score, 0.5F);
    EXPECT_EQ(p.mask.toBitmap(), (Bitmap{0, 0, 1, 0}));
    EXPECT_EQ(p.track, 9);
    EXPECT_EQ(p.box.x, 0);
    EXPECT_EQ(p.box.y, 1);
    EXPECT_EQ(p.box.width, 2);
    EXPECT_EQ(p.box.height, 1);
}

TEST_F(CocoPredictionsTest, whatIsAbsentHasADefault)
{
    const auto p = only(prediction({{"score", nullptr}}));
    EXPECT_EQ(p.score, 1);
    EXPECT_EQ(p.track, InstancePrediction::NO_TRACK);
    EXPECT_EQ(p.box.x, 0);
    EXPECT_EQ(p.box.y, 1);
    EXPECT_EQ(p.box.width, 1);
    EXPECT_EQ(p.box.height, 1);
}

TEST_F(CocoPredictionsTest, readsUncompressedRunsAndPolygons)
{
    EXPECT_EQ(only(prediction({{"segmentation", {{"size", {2, 2}}, {"counts", {1, 1, 2}}}}}))
                  .mask.toBitmap(),
              (Bitmap{0, 0, 1, 0}));
    EXPECT_EQ(only(prediction({{"segmentation", {{1, 0, 2, 0, 2, 2, 1, 2}}}})).mask.toBitmap(),
              (Bitmap{0, 1, 0, 1}));
}

TEST_F(CocoPredictionsTest, categoriesHaveNamesFromWhereTheyAreGiven)
{
    const auto nameIn = [&](const json& p, const CategoryNames& names = {}) {
        return only(p, names).categories.at(0).name;
    };
    EXPECT_EQ(nameIn(prediction({{"category_name", "stool"}})), "stool");
    EXPECT_EQ(nameIn(prediction(), {{62, "Stuhl"}}), "Stuhl");
    EXPECT_EQ(nameIn(prediction({{"category_id", 500}}), {{500, "robot"}}), "robot");
    const json withNames = {{"annotations", {prediction()}},
                            {"categories", {{{"id", 62}, {"name", "own"}}}}};
    EXPECT_EQ(instancesOf(load(withNames), 3)[0].categories[0].name, "own");
}

TEST_F(CocoPredictionsTest, classScoresBecomeTheDistribution)
{
    const auto p = only(prediction({{"class_scores", {{"tv", 0.2}, {"62", 0.6}, {"bed", 0}}}}));
    ASSERT_EQ(p.categories.size(), 2U);
    EXPECT_EQ(p.categories[0].name, "chair");
    EXPECT_NEAR(p.categories[0].probability, 0.75, 1e-6);
    EXPECT_EQ(p.categories[1].name, "tv");
    EXPECT_NEAR(p.categories[1].probability, 0.25, 1e-6);
    EXPECT_EQ(p.score, 0.5F);
}

TEST_F(CocoPredictionsTest, framesWithoutPredictionsAreEmpty)
{
    const auto predictions = load({prediction(), prediction({{"image_id", 8}})});
    EXPECT_EQ(predictions.count(), 2U);
    MatchedPredictions matched(predictions, frames(10));
    EXPECT_EQ(matched.countFor(3), 1U);
    EXPECT_EQ(matched.countFor(4), 0U);
    const auto none = matched.instancesFor(4, 2, 2);
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->instances.empty());
    EXPECT_EQ(none->imageWidth, 2);
}

TEST_F(CocoPredictionsTest, framesThatAListLacksWereNotSeen)
{
    const json root = {{"images",
                        {{{"id", 3}, {"file_name", "seq-02/frame-000000.color.png"}},
                         {{"id", 4}, {"file_name", "seq-01/frame-000000.color.png"}}}},
                       {"annotations", {prediction(), prediction({{"image_id", 4}})}}};
    const auto predictions = load(root);
    MatchedPredictions matched(predictions, {{0, "seq-02/frame-000000.color.png"},
                                             {1, "seq-01/frame-000000.color.png"},
                                             {2, "seq-01/frame-000001.color.png"}});
    EXPECT_EQ(matched.countFor(0), 1U);
    EXPECT_EQ(matched.countFor(1), 1U);
    EXPECT_FALSE(matched.instancesFor(2, 2, 2));
}

TEST_F(CocoPredictionsTest, masksMustBeOfTheImagesSize)
{
    const auto predictions = load(json::array({prediction()}));
    MatchedPredictions matched(predictions, frames(4));
    try {
        static_cast<void>(matched.instancesFor(3, 640, 480));
        FAIL() << "no exception";
    } catch (const InputError& e) {
        EXPECT_EQ(e.what(), m_file +
                                ": the masks of image_id 3 are of 2x2 pixels but the image has"
                                " 640x480");
    }
}

TEST_F(CocoPredictionsTest, oneMaskOfAnotherSizeIsLeftOut)
{
    const json odd = {{"segmentation", {{"size", {3, 2}}, {"counts", {1, 5}}}}};
    const auto predictions = load({prediction(odd), prediction(), prediction()}, CHAIR);
    MatchedPredictions matched(predictions, frames(4));
    EXPECT_EQ(matched.instancesFor(3, 2, 2)->instances.size(), 2U);
    ASSERT_EQ(matched.warnings().size(), 1U);
    EXPECT_EQ(matched.warnings()[0],
              "1 odd entry left out (--strict: an error), the first: " + m_file +
                  ": prediction 0 (image_id 3): the mask is of 2x3 pixels, the image of 2x2");
}

TEST_F(CocoPredictionsTest, anOddEntryOfManyIsLeftOutAndNamed)
{
    for (const json& changes :
         std::vector<json>{{{"segmentation", {{1, 2, 3, 4}}}},
                           {{"segmentation", json::array()}},
                           {{"score", 1.01}},
                           {{"score", "high"}},
                           {{"category_id", "chair"}},
                           {{"image_id", 1.5}},
                           {{"segmentation", {{"size", {2, 2}}, {"counts", {3}}}}}})
    {
        const json list = {prediction(), prediction(changes), prediction()};
        const auto predictions = load(list);
        EXPECT_EQ(predictions.count(), 2U) << changes.dump();
        EXPECT_EQ(predictions.leftOut().count(), 1U) << changes.dump();
        EXPECT_EQ(predictions.leftOut().first().find(m_file + ": prediction 1"), 0U);
        EXPECT_THROW(load(list, {}, true), InputError) << changes.dump();
    }
}

TEST_F(CocoPredictionsTest, anOddBoxOrPolygonIsLeftOutButNotItsPrediction)
{
    const json square = {1, 0, 2, 0, 2, 2, 1, 2};
    for (const json& changes : std::vector<json>{{{"bbox", {1, 2, 3}}},
                                                 {{"bbox", {1, 2, -3, 4}}},
                                                 {{"bbox", {1, 2, 3, "4"}}},
                                                 {{"bbox", 5}},
                                                 {{"segmentation", {square, {0, 0, 1, 1}}}}})
    {
        const auto predictions = load(json::array({prediction(changes)}));
        EXPECT_EQ(predictions.count(), 1U) << changes.dump();
        EXPECT_EQ(predictions.leftOut().count(), 1U) << changes.dump();
        EXPECT_EQ(instancesOf(predictions, 3)[0].box.width, 1) << "the mask's";
        EXPECT_THROW(load(json::array({prediction(changes)}), {}, true), InputError);
    }
    json null = prediction();
    null["bbox"] = nullptr;
    EXPECT_EQ(load(json::array({null})).leftOut().count(), 1U);
}

TEST_F(CocoPredictionsTest, roundingDoesNotCount)
{
    const auto predictions = load(json::array({prediction({{"score", 1.0000001}})}), {}, true);
    EXPECT_EQ(instancesOf(predictions, 3)[0].score, 1.0F);
}

TEST_F(CocoPredictionsTest, pythonsNanIsOddAndNotTheEndOfTheFile)
{
    const std::string good = prediction().dump(), entry = good.substr(0, good.find("0.5"));
    const std::string rest = good.substr(good.find("0.5") + 3);
    for (const std::string odd : {"NaN", "Infinity", "-Infinity"}) {
        const auto predictions = loadText("[" + entry + odd + rest + "," + good + "]");
        EXPECT_EQ(predictions.count(), 1U) << odd;
        EXPECT_NE(predictions.leftOut().first().find("score is not a number"), std::string::npos);
    }
    const auto named = loadText("[" + prediction({{"category_name", "a \\\" NaN"}}).dump() + "," +
                                entry + "NaN" + rest + "]");
    EXPECT_EQ(instancesOf(named, 3)[0].categories[0].name, "a \\\" NaN") << "texts stay";
}

TEST_F(CocoPredictionsTest, readsEveryWayToWriteAList)
{
    const std::string p = prediction().dump(), list = "[" + p + "," + p + "]";
    for (const std::string& text :
         {list, "\xEF\xBB\xBF" + list, p + "\n" + p + "\n", R"({"predictions": )" + list + "}",
          R"({"results": )" + list + "}", R"({"annotations": )" + list + "}",
          R"({"3": )" + list + R"(, "4": []})"})
        EXPECT_EQ(loadText(text).count(), 2U) << text;
    EXPECT_EQ(loadText("[]").count(), 0U);
    EXPECT_EQ(complaint(std::string("\xFF\xFE[\0", 4)), " is UTF-16 text: save it as UTF-8");
}

TEST_F(CocoPredictionsTest, readsPolygonsInEveryForm)
{
    const json flat = {1, 0, 2, 0, 2, 2, 1, 2}, pairs = {{1, 0}, {2, 0}, {2, 2}, {1, 2}};
    for (const json& polygons : {json::array({flat}), flat, pairs, json::array({pairs})})
        EXPECT_EQ(only(prediction({{"segmentation", polygons}})).mask.toBitmap(),
                  (Bitmap{0, 1, 0, 1}))
            << polygons.dump();
    EXPECT_EQ(only(prediction({{"segmentation", {{"size", {2, 2}}, {"counts", "b'112'"}}}}))
                  .mask.toBitmap(),
              (Bitmap{0, 0, 1, 0}));
    EXPECT_NE(complaint(prediction({{"segmentation", {{0.1, 0.1, 0.9, 0.1, 0.9, 0.9}}}}))
                  .find("pixels are expected"),
              std::string::npos);
}

TEST_F(CocoPredictionsTest, numbersMayBeWrittenAsTextOrWithAPoint)
{
    for (const json& image : {json(3), json(3.0), json("3"), json("000003")})
        EXPECT_EQ(instancesOf(load(json::array({prediction({{"image_id", image}})})), 3).size(), 1U)
            << image.dump();
    EXPECT_EQ(only(prediction({{"category_id", 62.0}})).categories[0].name, "chair");
}

TEST_F(CocoPredictionsTest, cocosEightyAreNoticedWhereNothingElseIsPossible)
{
    // 0 is no number of COCO's, and 68 none of a category that has annotations; 80 is toothbrush
    // only where the 80 count from 1.
    const auto names = [&](const std::vector<int>& ids) {
        json list;
        for (const int id : ids) list.push_back(prediction({{"category_id", id}}));
        const auto predictions = load(list);
        std::vector<std::string> result;
        for (const auto& i : instancesOf(predictions, 3)) result.push_back(i.categories[0].name);
        return result;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names({0, 56, 79}), (Names{"person", "chair", "toothbrush"}));
    EXPECT_EQ(names({57, 68, 80}), (Names{"chair", "cell phone", "toothbrush"}));
    EXPECT_EQ(names({62, 90}), (Names{"chair", "toothbrush"}));
    EXPECT_THROW(names({13, 12}), InputError) << "streets, from 0 or from 1?";
    EXPECT_THROW(names({0, 90}), InputError);
    EXPECT_THROW(names({62, 91}), InputError);
    const json seen = {prediction({{"category_id", 56}, {"category_name", "chair"}}),
                       prediction({{"category_id", 41}})};
    EXPECT_EQ(instancesOf(load(seen), 3)[1].categories[0].name, "cup") << "41 of 80, from 0";
}

/** Chair, cup, dining table and tv in COCO's three numberings: read in any other one, some of them
 * are food, sports or skateboards, which are not found in rooms. */
TEST_F(CocoPredictionsTest, ofSeveralNumberingsTheOneOfThingsInRoomsIsMeantAndItIsSaid)
{
    using Ids = std::vector<int>;
    for (const Ids& ids : {Ids{62, 47, 67, 72}, Ids{56, 41, 60, 62}, Ids{57, 42, 61, 63}})
        for (const json& image : {json(1), json("frame-000001")}) {
            json list;
            for (const int id : ids)
                list.push_back(prediction({{"image_id", image}, {"category_id", id}}));
            const auto predictions = load(list);
            MatchedPredictions matched(predictions,
                                       {{0, "frame-000000.png"}, {1, "frame-000001.png"}});
            const auto instances = matched.instancesFor(1, 2, 2);
            ASSERT_TRUE(instances);
            std::vector<std::string> names;
            for (const auto& i : instances->instances) names.push_back(i.categories[0].name);
            // Counted from 0 these are couch, fork, toilet and laptop: of rooms as well.
            if (ids[0] != 57) {
                EXPECT_EQ(names, (std::vector<std::string>{"chair", "cup", "dining table", "tv"}))
                    << ids[0] << " " << image;
            }
            std::string said;
            for (const std::string& sentence : matched.notes()) said += sentence;
            for (const std::string& sentence : matched.warnings()) said += sentence;
            EXPECT_NE(said.find("--categories"), std::string::npos) << said;
        }
}

TEST_F(CocoPredictionsTest, ultralyticsCountsItsCategoriesOnAfterAnother)
{
    struct Reading
    {
        std::string name, note, doubt;
    };
    const auto reading = [&](const json& image, const std::vector<int>& ids) {
        json list;
        for (const int id : ids)
            list.push_back(prediction({{"image_id", image}, {"category_id", id}}));
        const auto predictions = load(list);
        MatchedPredictions matched(predictions, {{0, "rgb/kitchen.png"}, {1, "rgb/7.png"}});
        const size_t frame = image == "7" || image == 7 ? 1 : 0;
        const auto warnings = matched.warnings();
        return Reading{matched.instancesFor(frame, 2, 2)->instances[0].categories[0].name,
                       matched.notes().front(), warnings.empty() ? "" : warnings.front()};
    };
    // 56 is chair of COCO's 80 from 0, 57 chair from 1, and 62 chair of its 90.
    EXPECT_EQ(reading("kitchen", {56, 0}).name, "chair");
    EXPECT_EQ(reading("kitchen", {56, 0}).doubt, "");
    EXPECT_NE(reading("kitchen", {56, 0}).note.find("--categories"), std::string::npos);
    EXPECT_EQ(reading("kitchen", {56, 41}).name, "chair");
    EXPECT_NE(reading("kitchen", {56, 41}).note.find("--categories"), std::string::npos);
    EXPECT_NE(reading("kitchen", {57, 42}).doubt.find("counted from 1"), std::string::npos);
    EXPECT_EQ(reading("kitchen", {57, 80}).name, "chair");
    EXPECT_EQ(reading("kitchen", {62, 90}).name, "chair");
    for (const json& image : {json(7), json("7"), json("rgb/kitchen.png"), json("kitchen.jpg")}) {
        EXPECT_EQ(reading(image, {62, 90}).doubt, "") << image;
        EXPECT_EQ(reading(image, {62, 47}).name, "chair") << image;
        const Reading usual = reading(image, {62, 47});
        EXPECT_NE((usual.note + usual.doubt).find("--categories"), std::string::npos) << image;
    }
}

TEST_F(CocoPredictionsTest, aTenthOfThePredictionsMayHaveAnUnknownCategory)
{
    const auto withOdd = [&](int odd, int count) {
        json list;
        for (int i = 0; i < 10; ++i)
            list.push_back(prediction(i < count ? json{{"category_id", odd}} : json::object()));
        return list;
    };
    for (const int odd : {12, 200, 91000}) {
        const auto predictions = load(withOdd(odd, 1));
        EXPECT_EQ(predictions.leftOut().count(), 1U) << odd;
        EXPECT_EQ(predictions.leftOut().first(), m_file +
                                                     ": prediction 0 (image_id 3): category_id " +
                                                     std::to_string(odd) + " has no name");
        const auto instances = instancesOf(predictions, 3);
        ASSERT_EQ(instances.size(), 9U);
        EXPECT_EQ(instances[0].categories[0].name, "chair");
        EXPECT_NE(complaint(withOdd(odd, 2).dump()).find("--categories"), std::string::npos) << odd;
        json nine = withOdd(odd, 1);
        nine.erase(9);
        EXPECT_THROW(load(nine), InputError) << "more than a tenth";
        EXPECT_THROW(load(withOdd(odd, 1), {}, true), InputError) << odd;
        EXPECT_EQ(load(withOdd(odd, 1), CHAIR).count(), 9U) << odd;
        EXPECT_THROW(load(withOdd(odd, 2), CHAIR), InputError) << odd;
    }
}

TEST_F(CocoPredictionsTest, namesGivenFromZeroAreNotTakenForOnesFromOne)
{
    const CategoryNames two = {{0, "cup"}, {1, "chair"}};
    json list;
    for (int i = 0; i < 20; ++i) list.push_back(prediction({{"category_id", i == 0 ? 2 : 1}}));
    EXPECT_THROW(load(list, two), InputError);
    list[1]["category_id"] = 0;
    const auto predictions = load(list, two);
    EXPECT_EQ(predictions.count(), 19U);
    EXPECT_NE(predictions.notes().front().find("numbered 0 to 1"), std::string::npos);
}

TEST_F(CocoPredictionsTest, nullIsAsGoodAsAbsent)
{
    json p = prediction();
    for (const char* key : {"track_id", "class_scores", "category_name"}) p[key] = nullptr;
    EXPECT_EQ(only(p).categories[0].name, "chair");
    EXPECT_EQ(only(p).track, InstancePrediction::NO_TRACK);
    const json root = {{"images", nullptr}, {"categories", nullptr}, {"annotations", {p}}};
    const auto predictions = load(root, {}, true);
    EXPECT_FALSE(predictions.listsImages());
    EXPECT_EQ(instancesOf(predictions, 3).size(), 1U);
}

TEST_F(CocoPredictionsTest, polygonsAreScaledFromTheImageTheyWereDrawnOn)
{
    const auto listedAs = [](const json& width, const json& height, const json& polygon,
                             const json& box) {
        json p = prediction({{"image_id", 1}, {"segmentation", {polygon}}});
        if (!box.is_null()) p["bbox"] = box;
        return json{{"images", {{{"id", 1}, {"width", width}, {"height", height}}}},
                    {"annotations", {p}}};
    };
    // In a frame of 8x4 pixels columns 2 to 5 of row 1, whatever it was drawn on.
    const Bitmap expected = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0,
                             0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    struct Drawing
    {
        json width, height, polygon, box;
        const char* note;
    };
    for (const Drawing& d : std::vector<Drawing>{
             {8, 4, {2, 1, 6, 1, 6, 2, 2, 2}, {2, 1, 4, 1}, ""},
             {16, 8, {4, 2, 12, 2, 12, 4, 4, 4}, {4, 2, 8, 2}, "from 16x8 to 8x4 pixels"},
             {16.0, "8", {4, 2, 12, 2, 12, 4, 4, 4}, {4, 2, 8, 2}, "from 16x8 to 8x4 pixels"},
             {16, 8, {4, 2, 12, 2, 12, 4, 4, 4}, nullptr, "from 16x8 to 8x4 pixels"},
             {8,
              8,
              {2, 2, 6, 2, 6, 4, 2, 4},
              {2, 2, 4, 2},
              "from 8x8 to 8x4 pixels, which is right if"},
             {0, 0, {2, 1, 6, 1, 6, 2, 2, 2}, {2, 1, 4, 1}, ""}})
    {
        const auto predictions = load(listedAs(d.width, d.height, d.polygon, d.box), CHAIR);
        MatchedPredictions matched(predictions, frames(1));
        const auto p = matched.instancesFor(0, 8, 4)->instances.at(0);
        EXPECT_EQ(p.mask.toBitmap(), expected) << d.width << d.height;
        EXPECT_EQ((std::vector<int>{p.box.x, p.box.y, p.box.width, p.box.height}),
                  (std::vector<int>{2, 1, 4, 1}))
            << d.width << d.height;
        std::string told;
        for (const auto& note : matched.notes())
            if (note.find("scaled") != std::string::npos) told += note;
        EXPECT_EQ(told.empty(), std::string(d.note).empty()) << told;
        EXPECT_NE(told.find(d.note), std::string::npos) << told;
    }
    const auto turned = load(listedAs(4, 8, {1, 2, 2, 2, 2, 6, 1, 6}, nullptr), CHAIR);
    MatchedPredictions matched(turned, frames(1));
    EXPECT_THROW(static_cast<void>(matched.instancesFor(0, 8, 4)), InputError);
    const auto masks = load({{"images", {{{"id", 1}, {"width", 4}, {"height", 4}}}},
                             {"annotations", {prediction({{"image_id", 1}})}}},
                            CHAIR);
    MatchedPredictions refused(masks, frames(1));
    EXPECT_THROW(static_cast<void>(refused.instancesFor(0, 4, 4)), InputError) << "RLE of 2x2";
    EXPECT_NO_THROW(static_cast<void>(refused.instancesFor(0, 2, 2)));
}

TEST_F(CocoPredictionsTest, sizesThatPolygonsDoNotLieInAreNotUsed)
{
    const json p = prediction({{"image_id", 1}, {"segmentation", {{5, 1, 8, 1, 8, 2, 5, 2}}}});
    const auto predictions =
        load({{"images", {{{"id", 1}, {"width", 4}, {"height", 2}}}}, {"annotations", {p}}}, CHAIR);
    MatchedPredictions matched(predictions, frames(1));
    EXPECT_EQ(matched.instancesFor(0, 8, 4)->instances.at(0).mask.area(), 3U);
    ASSERT_EQ(matched.warnings().size(), 1U);
    EXPECT_NE(matched.warnings()[0].find("1 polygon of 1 lie outside"), std::string::npos)
        << matched.warnings()[0];
}

TEST_F(CocoPredictionsTest, withoutFramesTheOddOnesAreToldToo)
{
    const auto predictions =
        load({prediction({{"image_id", 50}}), prediction({{"image_id", 1.5}})});
    try {
        MatchedPredictions(predictions, frames(4));
        FAIL() << "no exception";
    } catch (const InputError& e) {
        const std::string what = e.what();
        EXPECT_NE(what.find("1 of 1 prediction have no frame"), std::string::npos) << what;
        EXPECT_NE(what.find("1 odd entry left out"), std::string::npos) << what;
    }
}

TEST_F(CocoPredictionsTest, masksOutsideTheirBoxesAreNotTakenAsTheyAre)
{
    // Rows 0 and 1 of 4x8 pixels, set along the rows; down the columns that is a block on the left.
    const json rows = {{"segmentation", {{"size", {8, 4}}, {"counts", {0, 8, 24}}}},
                       {"bbox", {0, 0, 4, 2}}};
    EXPECT_NE(complaint(prediction(rows)).find("transpose"), std::string::npos);
    // Columns 2 and 3, rows 6 and 7; the box is its corners.
    const json corners = {{"segmentation", {{2, 6, 4, 6, 4, 8, 2, 8}}}, {"bbox", {2, 6, 4, 8}}};
    const auto predictions = load(json::array({prediction(corners)}));
    EXPECT_NE(predictions.notes().back().find("masks' own boxes"), std::string::npos);
    MatchedPredictions matched(predictions, frames(4));
    EXPECT_EQ(matched.instancesFor(3, 4, 8)->instances.at(0).box.width, 2);
}

TEST_F(CocoPredictionsTest, aTenthOfThePredictionsMayHaveNoFrame)
{
    json list;
    for (int i = 0; i < 10; ++i) list.push_back(prediction({{"image_id", i}}));
    const auto nine = load(list, CHAIR);
    MatchedPredictions matched(nine, frames(9));
    ASSERT_EQ(matched.warnings().size(), 1U);
    EXPECT_EQ(matched.warnings()[0].find(m_file + ": 1 of 10 predictions have no frame, the first "
                                                  "of image_id 9"),
              0U)
        << matched.warnings()[0];
    EXPECT_THROW(MatchedPredictions(nine, frames(8)), InputError);
    const auto strict = load(list, {}, true);
    EXPECT_THROW(MatchedPredictions(strict, frames(9)), InputError);
    EXPECT_NO_THROW(MatchedPredictions(strict, frames(10)));
}

TEST_F(CocoPredictionsTest, saysWhereJsonBreaksOff)
{
    EXPECT_EQ(complaint(std::string("[\n  {\"image_id\": 3,\n")),
              " is not valid JSON at line 3, column 1, its end: it is cut off");
    EXPECT_EQ(complaint(std::string("[\n  {\"image_id\": }]")),
              " is not valid JSON at line 2, column 16: correct it there");
    EXPECT_EQ(complaint(std::string("[{\"score\": Nan}]")),
              " is not valid JSON at line 1, column 12: correct it there");
    EXPECT_EQ(complaint(std::string("")), " is empty: JSON is expected");
    EXPECT_EQ(complaint(std::string("{\"image_id\": 3}")).substr(0, 35),
              " is not in the COCO results format:");
    EXPECT_THROW(CocoPredictions(m_folder.file("missing.json")), InputError);
}

TEST_F(CocoPredictionsTest, saysWhichPredictionIsWrong)
{
    const std::string where = ": prediction 0 (image_id 3): ";
    EXPECT_EQ(complaint(prediction({{"category_id", 105}})),
              ": category_id 105 has no name: give the names with --categories (1 of 1 prediction"
              " without a name)");
    EXPECT_EQ(complaint(prediction({{"score", 1.5}})), where + "score 1.5 is not in [0,1]");
    EXPECT_EQ(complaint(prediction({{"image_id", nullptr}})),
              ": prediction 0: there is no image_id");
    for (const json& changes :
         std::vector<json>{{{"score", -0.1}},
                           {{"score", "high"}},
                           {{"image_id", 1.5}},
                           {{"category_id", nullptr}},
                           {{"category_name", 5}},
                           {{"class_scores", {{"chair", -1}}}},
                           {{"class_scores", {{"chair", 0}}}},
                           {{"class_scores", {{"500", 0.1}}}},
                           {{"class_scores", {0.1, 0.2}}},
                           {{"track_id", "a"}},
                           {{"segmentation", nullptr}},
                           {{"segmentation", 5}},
                           {{"segmentation", json::array()}},
                           {{"segmentation", {{"size", {2, 2}}}}},
                           {{"segmentation", {{"size", {2}}, {"counts", "112"}}}},
                           {{"segmentation", {{"size", {2, 3}}, {"counts", "112"}}}},
                           {{"segmentation", {{"size", {-2, -2}}, {"counts", "112"}}}},
                           {{"segmentation", {{"size", {2, 2}}, {"counts", "1 2"}}}},
                           {{"segmentation", {{"size", {2, 2}}, {"counts", {1, -1, 4}}}}},
                           {{"segmentation", {{"size", {2, 2}}, {"counts", {1, "a"}}}}}})
        EXPECT_NE(complaint(prediction(changes)), "") << changes.dump();
    EXPECT_NE(complaint(json(5)), "");
}

TEST_F(CocoPredictionsTest, masksOfARealNetworkHaveTheAreaItSays)
{
    SKIP_WITHOUT_REDKITCHEN();
    const auto file = test::redkitchen() / "predictions_coco.json";
    const CocoPredictions predictions(file.string());
    const json root = json::parse(test::readFile(file));
    EXPECT_EQ(predictions.count(), 1072U);
    std::map<int64_t, std::vector<json>> byImage;
    for (const auto& p : root) byImage[p.at("image_id").get<int64_t>()].push_back(p);
    MatchedPredictions matched(predictions, frames(byImage.rbegin()->first + 1));
    for (const auto& [image, expected] : byImage) {
        const auto found = matched.instancesFor(static_cast<size_t>(image), 640, 480);
        ASSERT_EQ(found->instances.size(), expected.size());
        for (size_t i = 0; i < expected.size(); ++i) {
            const auto& p = found->instances[i];
            EXPECT_EQ(p.mask.area(), expected[i].at("area").get<uint64_t>());
            EXPECT_EQ(p.categories.front().name, expected[i].at("category_name"));
            // A mask lies in its box, but for the rim that upsampling a prototype adds.
            const PixelBox mask = p.mask.boundingBox();
            if (p.mask.empty()) continue;
            EXPECT_GE(mask.x, p.box.x - 4);
            EXPECT_GE(mask.y, p.box.y - 4);
            EXPECT_LE(mask.x + mask.width, p.box.x + p.box.width + 4);
            EXPECT_LE(mask.y + mask.height, p.box.y + p.box.height + 4);
        }
    }
}
