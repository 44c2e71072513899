// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/datasets/CocoPredictions.h"
#include "voxeland/datasets/RgbdDatasetReader.h"
#include "voxeland/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voxeland;
using nlohmann::json;

namespace
{
/** Only row 1 of column 0 of a 2x2 image is set (see test_CocoMasks). */
const json MASK = {{"size", {2, 2}}, {"counts", "112"}};

json prediction(const json& changes = json::object())
{
    json p = {{"image_id", 3}, {"category_id", 62}, {"score", 0.5}, {"segmentation", MASK}};
    p.update(changes);
    for (const auto& [key, value] : changes.items())
        if (value.is_null()) p.erase(key);
    return p;
}

class CocoPredictionsTest : public testing::Test
{
 protected:
    CocoPredictions load(const json& root, const CategoryNames& names = {}) const
    {
        return loadText(root.dump(), names);
    }
    CocoPredictions loadText(const std::string& text, const CategoryNames& names = {}) const
    {
        test::writeFile(m_file, text);
        return CocoPredictions(m_file, names);
    }
    /** The only prediction of the file, in frame 3 of 2x2 pixels. */
    InstancePrediction only(const json& p, const CategoryNames& names = {}) const
    {
        return load(json::array({p}), names).instancesFor({3, ""}, 2, 2)->instances.at(0);
    }
    /** What the constructor says about a text. */
    std::string complaint(const std::string& text) const
    {
        try {
            loadText(text);
        } catch (const InputError& e) {
            return std::string(e.what()).substr(m_file.size());
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
    EXPECT_EQ(load(withNames).instancesFor({3, ""}, 2, 2)->instances[0].categories[0].name, "own");
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
    EXPECT_EQ(predictions.countFor({3, ""}), 1U);
    EXPECT_EQ(predictions.countFor({4, ""}), 0U);
    const auto none = predictions.instancesFor({4, ""}, 2, 2);
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->instances.empty());
    EXPECT_EQ(none->imageWidth, 2);
}

TEST_F(CocoPredictionsTest, listedImagesAreFoundByName)
{
    const json root = {{"images",
                        {{{"id", 3}, {"file_name", "seq-02/frame-000000.color.png"}},
                         {{"id", 4}, {"file_name", "seq-01/frame-000000.color.png"}},
                         {{"id", 5}, {"file_name", "some/where/frame-000001.color.png"}}}},
                       {"annotations", {prediction(), prediction({{"image_id", 5}})}}};
    const auto predictions = load(root);
    EXPECT_EQ(predictions.countFor({0, "seq-02/frame-000000.color.png"}), 1U);
    EXPECT_EQ(predictions.countFor({3, "seq-01/frame-000000.color.png"}), 0U);
    EXPECT_EQ(predictions.countFor({1, "seq-01/frame-000001.color.png"}), 1U) << "by bare name";
    EXPECT_FALSE(predictions.instancesFor({3, "frame-000003.color.png"}, 2, 2))
        << "a frame the detector has not seen";
    EXPECT_FALSE(predictions.instancesFor({3, "frame-000000.color.png"}, 2, 2)) << "ambiguous";
    EXPECT_EQ(predictions.countFor({5, ""}), 1U) << "a rawlog's frames have numbers only";
}

TEST_F(CocoPredictionsTest, masksMustBeOfTheImagesSize)
{
    try {
        static_cast<void>(load(json::array({prediction()})).instancesFor({3, ""}, 640, 480));
        FAIL() << "no exception";
    } catch (const InputError& e) {
        EXPECT_EQ(e.what(), m_file +
                                ": the masks of image_id 3 are of 2x2 pixels but the image has"
                                " 640x480");
    }
}

TEST_F(CocoPredictionsTest, saysWhereJsonBreaksOff)
{
    EXPECT_EQ(complaint(std::string("[\n  {\"image_id\": 3,\n")),
              " is not valid JSON at line 3, column 1, its end: it is cut off");
    EXPECT_EQ(complaint(std::string("[\n  {\"image_id\": }]")),
              " is not valid JSON at line 2, column 16");
    EXPECT_EQ(complaint(std::string("[{\"score\": NaN}]")),
              " is not valid JSON at line 1, column 12");
    EXPECT_EQ(complaint(std::string("")),
              " is not valid JSON at line 1, column 1, its end: it is cut off");
    EXPECT_EQ(complaint(std::string("{\"image_id\": 3}")).substr(0, 35),
              " is not in the COCO results format:");
    EXPECT_THROW(CocoPredictions(m_folder.file("missing.json")), InputError);
}

TEST_F(CocoPredictionsTest, saysWhichPredictionIsWrong)
{
    const std::string where = ": prediction 0 (image_id 3): ";
    EXPECT_EQ(complaint(prediction({{"category_id", 105}})),
              where + "category_id 105 has no name: give the names with --categories");
    EXPECT_EQ(complaint(prediction({{"score", 1.5}})), where + "score 1.500000 is not in [0,1]");
    EXPECT_EQ(complaint(prediction({{"image_id", nullptr}})),
              ": prediction 0: there is no image_id");
    for (const json& changes :
         std::vector<json>{{{"score", -0.1}},
                           {{"score", "high"}},
                           {{"image_id", "a"}},
                           {{"image_id", 1.5}},
                           {{"category_id", nullptr}},
                           {{"category_name", 5}},
                           {{"class_scores", {{"chair", -1}}}},
                           {{"class_scores", {{"chair", 0}}}},
                           {{"class_scores", {{"500", 0.1}}}},
                           {{"class_scores", {0.1, 0.2}}},
                           {{"track_id", "a"}},
                           {{"bbox", {1, 2, 3}}},
                           {{"bbox", {1, 2, -3, 4}}},
                           {{"bbox", {1, 2, 3, "4"}}},
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

TEST_F(CocoPredictionsTest, wrongPolygonsAreNoticed)
{
    const auto predictions = load(json::array({prediction({{"segmentation", {{1, 2, 3}}}})}));
    EXPECT_THROW(static_cast<void>(predictions.instancesFor({3, ""}, 2, 2)), InputError);
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
    for (const auto& [image, expected] : byImage) {
        const auto found = predictions.instancesFor({image, ""}, 640, 480);
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
