// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/errors.h"
#include "voxeland/simulation/NoisyDetector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace voxeland;
using namespace voxeland::simulation;

namespace
{
/** Two chairs (simple boxes) that do not touch, a cup on the first, and a wardrobe. */
class DetectorScene : public ::testing::Test
{
 protected:
    static CameraOptions smallImage()
    {
        CameraOptions options;
        options.width = 160;
        options.height = 120;
        return options;
    }

    DetectorScene()
    {
        m_scene.addRoom({-5, -5, 5, 5});
        m_left = addBox("chair", {3, 0.6F, 0}, {0.3F, 0.3F, 0.3F});
        m_right = addBox("chair", {3, -0.5F, 0}, {0.3F, 0.3F, 0.3F});
        m_cup = addBox("cup", {2.9F, 0.6F, 0.4F}, {0.1F, 0.1F, 0.1F}, m_left);
        m_wardrobe = addBox("wardrobe", {4.5F, 0, 0.9F}, {0.2F, 0.6F, 0.4F});
        m_view = SceneRenderer(m_scene, m_camera).render(m_pose);
    }

    ObjectId addBox(const char* category, const Vector3& c, const Vector3& half,
                    ObjectId standsOn = STRUCTURE)
    {
        const auto id = m_scene.addObject(category, standsOn);
        m_scene.addSolid(Solid(Solid::Shape::Box, {c.x, c.y, c.z, 0, 0, 0}, half, {}), id);
        return id;
    }

    [[nodiscard]] NoisyDetector detector(DetectorOptions options) const
    {
        options.tracks = true;
        return {m_scene, m_camera, options, Random(1)};
    }

    [[nodiscard]] std::vector<uint8_t> exactMask(ObjectId id) const
    {
        std::vector<uint8_t> mask;
        for (const ObjectId pixel : m_view.objects) mask.push_back(pixel == id ? 1 : 0);
        return mask;
    }

    static double iou(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b)
    {
        int both = 0, any = 0;
        for (size_t i = 0; i < a.size(); ++i) {
            both += a[i] & b[i];
            any += a[i] | b[i];
        }
        return double(both) / any;
    }

    Scene m_scene;
    RenderCamera m_camera{smallImage()};
    mrpt::math::TPose3D m_pose{0, 0, 0.3, 0, 0, 0};
    RenderedView m_view;
    ObjectId m_left, m_right, m_cup, m_wardrobe;
};

DetectorOptions perfect()
{
    return DetectorOptions::preset("perfect");
}
}  // namespace

TEST_F(DetectorScene, PerfectDetectorGivesTheExactMasksAndCategories)
{
    const auto found = detector(perfect()).detect(m_view, m_pose, Random(1));
    ASSERT_EQ(found.size(), 4U);
    for (const auto& prediction : found) {
        const auto id = static_cast<ObjectId>(prediction.track);
        EXPECT_EQ(prediction.mask.toBitmap(), exactMask(id));
        if (id != m_wardrobe) {
            EXPECT_EQ(prediction.categories.front().name, m_scene.object(id).category);
        }
        EXPECT_GT(prediction.categories.front().probability, 0.999F);
        EXPECT_EQ(prediction.box.width, prediction.mask.boundingBox().width);
    }
}

TEST_F(DetectorScene, HasNoWordForAWardrobe)
{
    for (const auto& p : detector(perfect()).detect(m_view, m_pose, Random(1)))
        if (p.track == m_wardrobe) {
            EXPECT_TRUE(p.categories.front().name == "refrigerator" ||
                        p.categories.front().name == "oven");
        }
}

TEST_F(DetectorScene, TracksAreNotToldUnlessAskedFor)
{
    const NoisyDetector d(m_scene, m_camera, perfect(), Random(1));
    for (const auto& p : d.detect(m_view, m_pose, Random(1)))
        EXPECT_EQ(p.track, InstancePrediction::NO_TRACK);
}

TEST_F(DetectorScene, MissesAsOftenAsItSays)
{
    DetectorOptions options = perfect();
    options.detectionRate = 0.9F;
    options.halfRateArea = 800;
    options.halfRateVisible = 0.25F;
    const auto d = detector(options);
    const auto seen = d.visibility(m_view, m_pose);
    constexpr int RUNS = 2000;
    std::map<int64_t, int> counts;
    for (uint64_t run = 0; run < RUNS; ++run)
        for (const auto& p : d.detect(m_view, m_pose, Random(run))) ++counts[p.track];
    for (const ObjectId id : {m_left, m_cup, m_wardrobe}) {
        const double expected = d.detectionProbability(seen[id - 1U]);
        EXPECT_NEAR(counts[id] / double(RUNS), expected,
                    5 * std::sqrt(expected * (1 - expected) / RUNS))
            << id;
    }
    EXPECT_LT(counts[m_cup], counts[m_left]) << "small things are missed more often";
    // By the formula: 16 pixels of a 160 wide image count as one of 640.
    const double area = 16 * seen[m_cup - 1U].pixels, share = seen[m_cup - 1U].share;
    EXPECT_NEAR(d.detectionProbability(seen[m_cup - 1U]),
                0.9 * area * area / (area * area + 800.0 * 800.0) * share * share /
                    (share * share + 0.0625),
                1e-5);
}

TEST_F(DetectorScene, HiddenAndCutObjectsAreLessVisible)
{
    const auto d = detector(perfect());
    const auto whole = d.visibility(m_view, m_pose)[m_left - 1U];
    EXPECT_GT(whole.share, 0.8F);
    const mrpt::math::TPose3D aside(0, 0, 0.3, -0.42, 0, 0);  // it leaves the image on the left
    const auto cut = d.visibility(SceneRenderer(m_scene, m_camera).render(aside), aside);
    EXPECT_GT(cut[m_left - 1U].pixels, 0);
    EXPECT_LT(cut[m_left - 1U].share, 0.8F * whole.share);
}

TEST_F(DetectorScene, InventsAsManyDetectionsAsItSays)
{
    DetectorOptions options = perfect();
    options.detectionRate = 0;
    options.falseDetections = 0.4F;
    const auto d = detector(options);
    constexpr int RUNS = 3000;
    double sum = 0;
    for (uint64_t run = 0; run < RUNS; ++run)
        sum += double(d.detect(m_view, m_pose, Random(run)).size());
    // A few of the ellipses lie outside of the image's corners and are not reported.
    EXPECT_NEAR(sum / RUNS, 0.4, 5 * std::sqrt(0.4 / RUNS) + 0.01);
}

TEST_F(DetectorScene, MasksBleedOverTheBoundary)
{
    DetectorOptions grown = perfect();
    grown.boundaryBias = 8;  // 2 pixels of this image
    for (const auto& p : detector(grown).detect(m_view, m_pose, Random(1))) {
        const auto exact = exactMask(static_cast<ObjectId>(p.track)), mask = p.mask.toBitmap();
        const auto box = p.mask.boundingBox();
        const auto before = RunLengthMask::fromBitmap(exact.data(), 160, 120).boundingBox();
        if (before.x < 3 || before.x + before.width > 157 || before.y < 3) continue;
        EXPECT_NEAR(box.width, before.width + 4, 2);
        for (size_t i = 0; i < mask.size(); ++i) EXPECT_GE(mask[i], exact[i]);
    }
    DetectorOptions wavy = perfect();
    wavy.boundaryNoise = 12;  // at least 1.5 pixels of this image
    for (const auto& p : detector(wavy).detect(m_view, m_pose, Random(1))) {
        const double overlap = iou(exactMask(static_cast<ObjectId>(p.track)), p.mask.toBitmap());
        EXPECT_GT(overlap, 0.3);
        EXPECT_LT(overlap, 1.0);
    }
}

TEST_F(DetectorScene, MasksSwallowWhatStandsOnTheObject)
{
    DetectorOptions options = perfect();
    options.swallowing = 1;
    for (const auto& p : detector(options).detect(m_view, m_pose, Random(1))) {
        if (p.track != m_left) continue;
        auto expected = exactMask(m_left);
        const auto cup = exactMask(m_cup);
        for (size_t i = 0; i < cup.size(); ++i) expected[i] = expected[i] | cup[i];
        EXPECT_EQ(p.mask.toBitmap(), expected);
    }
}

TEST_F(DetectorScene, ObjectsComeInPieces)
{
    DetectorOptions options = perfect();
    options.splitting = 1;
    std::map<int64_t, std::vector<uint8_t>> sums;
    const auto found = detector(options).detect(m_view, m_pose, Random(1));
    EXPECT_EQ(found.size(), 8U);
    for (const auto& p : found) {
        auto& sum = sums[p.track];
        const auto mask = p.mask.toBitmap();
        sum.resize(mask.size());
        for (size_t i = 0; i < mask.size(); ++i) sum[i] = static_cast<uint8_t>(sum[i] + mask[i]);
    }
    for (const auto& [id, sum] : sums) EXPECT_EQ(sum, exactMask(static_cast<ObjectId>(id)));
}

TEST_F(DetectorScene, DuplicatesHaveAnotherCategory)
{
    DetectorOptions options = perfect();
    options.duplicates = 1;
    const auto found = detector(options).detect(m_view, m_pose, Random(1));
    std::map<int64_t, std::vector<std::string>> names;
    for (const auto& p : found) names[p.track].push_back(p.categories.front().name);
    for (const auto& [id, list] : names) {
        ASSERT_EQ(list.size(), 2U);
        EXPECT_NE(list[0], list[1]);
    }
}

TEST_F(DetectorScene, ConfusionDependsOnTheDirection)
{
    DetectorOptions options = perfect();
    options.confidence = 3.5F;
    options.confusedObjects = 1;
    const Recognition recognition(m_scene, options, Random(1));
    Random random(1);
    int wrong = 0, changes = 0;
    std::string last;
    for (int degree = 0; degree < 360; ++degree) {
        const float a = static_cast<float>(degree) * 3.14159265F / 180;
        const Vector3 from{3 + 2 * std::cos(a), 0.6F + 2 * std::sin(a), 1};
        const std::string name = recognition.recognize(m_left, from, random).front().name;
        wrong += name == "chair" ? 0 : 1;
        changes += !last.empty() && name != last ? 1 : 0;
        last = name;
    }
    // A sector of 110 degrees, wrong where the fading confusion of 5 exceeds 3.5: from 25 degrees
    // of fading 0.3 on, so 55 + 12.5 - 0.7 * 25 = 50 degrees to each side.
    EXPECT_NEAR(wrong, 100, 3);
    EXPECT_LE(changes, 2);
}

TEST_F(DetectorScene, SameRandomNumbersSamePredictions)
{
    const auto d = detector(DetectorOptions::preset("hard"));
    const auto a = d.detect(m_view, m_pose, Random(9)), b = d.detect(m_view, m_pose, Random(9));
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].mask, b[i].mask);
        EXPECT_EQ(a[i].categories, b[i].categories);
        EXPECT_EQ(a[i].score, b[i].score);
    }
}

TEST(DetectorOptions, PresetsAreNamed)
{
    for (const auto& name : DetectorOptions::presets())
        EXPECT_NO_THROW(static_cast<void>(DetectorOptions::preset(name)));
    EXPECT_THROW(static_cast<void>(DetectorOptions::preset("medium")), ConfigurationError);
}
