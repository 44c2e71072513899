// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/SemanticVoxelMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace voxeland;

namespace
{
constexpr uint32_t MOST = 3;  // views of a category

/** A view of the origin from an azimuth [degrees], 2 m away. */
InstanceView viewFrom(double azimuth, uint32_t area, uint32_t frame = 0)
{
    InstanceView v;
    v.frame = frame;
    v.area = area;
    v.score = v.probability = 1;
    v.box = {static_cast<int32_t>(frame), 0, 10, 10};
    const double a = azimuth * M_PI / 180;
    v.camera = {static_cast<float>(2 * std::cos(a)), static_cast<float>(2 * std::sin(a)), 0};
    return v;
}

std::vector<uint32_t> framesOf(const InstanceViews& views, category_id_t category)
{
    std::vector<uint32_t> frames;
    for (const InstanceView& v : views.of(category)) frames.push_back(v.frame);
    return frames;
}

std::vector<InstanceView> randomViews(unsigned seed, size_t n)
{
    std::mt19937 random(seed);
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    std::vector<InstanceView> views;
    for (uint32_t i = 0; i < n; ++i) {
        views.push_back(viewFrom(upTo(359), static_cast<uint32_t>(100 + upTo(5000)), i));
        views.back().truncated = upTo(2) == 0;
        views.back().score = static_cast<float>(upTo(9)) / 10;
    }
    return views;
}
}  // namespace

TEST(InstanceView, QualityIsSizeTimesConfidenceHalvedWhereCut)
{
    InstanceView v = viewFrom(0, 400);
    EXPECT_FLOAT_EQ(v.quality(), 20);
    v.score = 0.5F;
    v.probability = 0.8F;
    EXPECT_FLOAT_EQ(v.quality(), 8);
    v.truncated = true;
    EXPECT_FLOAT_EQ(v.quality(), 4);
}

TEST(InstanceViews, OtherDirectionsCountBeforeSecondBestOnes)
{
    InstanceViews views;
    views.add(0, viewFrom(0, 900, 1), MOST);
    views.add(0, viewFrom(2, 800, 2), MOST);
    views.add(0, viewFrom(1, 700, 3), MOST);
    EXPECT_EQ(framesOf(views, 0), (std::vector<uint32_t>{1, 2, 3}));
    views.add(0, viewFrom(180, 100, 4), MOST);
    EXPECT_EQ(framesOf(views, 0), (std::vector<uint32_t>{1, 4, 2}));
    views.add(0, viewFrom(90, 400, 5), MOST);
    EXPECT_EQ(framesOf(views, 0), (std::vector<uint32_t>{1, 5, 4}));
}

TEST(InstanceViews, OfEqualViewsTheEarlierIsKept)
{
    InstanceViews views;
    for (const uint32_t frame : {7U, 2U, 9U, 4U}) views.add(0, viewFrom(0, 100, frame), MOST);
    EXPECT_EQ(framesOf(views, 0), (std::vector<uint32_t>{2, 4, 7}));
}

TEST(InstanceViews, WhatIsKeptDependsNeitherOnOrderNorOnMerges)
{
    constexpr uint32_t most = 8;
    for (unsigned seed = 0; seed < 20; ++seed) {
        auto all = randomViews(seed, 200);
        InstanceViews straight, shuffled, merged;
        for (const auto& v : all) straight.add(1, v, most);
        std::shuffle(all.begin(), all.end(), std::mt19937(seed + 100));
        for (const auto& v : all) shuffled.add(1, v, most);
        InstanceViews parts[3];
        for (size_t i = 0; i < all.size(); ++i) parts[i % 3].add(1, all[i], most);
        for (const auto& part : parts) merged.add(part, most);
        ASSERT_EQ(straight.of(1).size(), 8U);
        EXPECT_EQ(framesOf(shuffled, 1), framesOf(straight, 1)) << seed;
        EXPECT_EQ(framesOf(merged, 1), framesOf(straight, 1)) << seed;
    }
}

TEST(InstanceViews, OrderAndMergesDoNotMatterAmongManyCategoriesAndEqualViews)
{
    // Of few values, so that many views are equal but for a camera, a target, or nothing.
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        const auto upTo = [&](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
        std::vector<std::pair<category_id_t, InstanceView>> all;
        for (int i = 0; i < 400; ++i) {
            InstanceView v = viewFrom(0, 100);
            v.camera.x += 0.001F * static_cast<float>(upTo(3));
            v.target.z = 0.001F * static_cast<float>(upTo(3));
            v.area += static_cast<uint32_t>(upTo(2));
            all.emplace_back(upTo(14), v);
        }
        const auto bytesOf = [](const InstanceViews& views) {
            std::string text;
            for (const auto& [category, kept] : views.byCategory())
                for (const InstanceView& v : kept)
                    for (const float x : {static_cast<float>(category), v.camera.x, v.target.z,
                                          static_cast<float>(v.area)})
                        text += std::to_string(x) + " ";
            return text;
        };
        InstanceViews straight, parts[3], merged;
        for (const auto& [category, v] : all) straight.add(category, v, MOST);
        std::shuffle(all.begin(), all.end(), random);
        for (size_t i = 0; i < all.size(); ++i) parts[i % 3].add(all[i].first, all[i].second, MOST);
        for (const int part : {2, 0, 1}) merged.add(parts[part], MOST);
        EXPECT_EQ(bytesOf(merged), bytesOf(straight)) << seed;
    }
}

TEST(InstanceViews, ImpossibleOnesAreLeftOut)
{
    InstanceViews views;
    InstanceView v = viewFrom(0, 100);
    v.score = std::nanf("");
    views.add(0, v, MOST);
    v.score = -1;
    views.add(0, v, MOST);
    v = viewFrom(0, 100);
    v.camera.y = INFINITY;
    views.add(0, v, MOST);
    v = viewFrom(0, 100);
    v.target.z = std::nanf("");
    views.add(0, v, MOST);
    EXPECT_TRUE(views.byCategory().empty());
}

TEST(InstanceViews, EveryCategoryHasItsOwn)
{
    InstanceViews views;
    for (category_id_t c = 0; c < 40; ++c) views.add(c, viewFrom(0, 100 + c, c), MOST);
    for (category_id_t c = 0; c < 40; ++c) EXPECT_EQ(framesOf(views, c), std::vector<uint32_t>{c});
}

TEST(InstanceViews, NoneAreKeptIfNoneAreWanted)
{
    InstanceViews views;
    views.add(0, viewFrom(0, 100), 0);
    EXPECT_TRUE(views.byCategory().empty());
}

TEST(InstanceViews, AMergedInstanceHasTheViewsAndHistoryOfBoth)
{
    SemanticVoxelMap map;
    map.categories().add("chair");
    map.createInstance().views.add(0, viewFrom(0, 100, 1), MOST);
    map.createInstance().views.add(0, viewFrom(90, 100, 2), MOST);
    map.createInstance();
    map.addEvidence({0, 0, 0}, 1, 1);
    map.addEvidence({0, 0, 0}, 2, 1);
    map.addEvidence({0, 0, 0}, 3, 1);
    map.merge(2, 3, 10);
    map.merge(1, 2, 20);
    EXPECT_EQ(framesOf(map.instance(1).views, 0), (std::vector<uint32_t>{1, 2}));
    const auto& history = map.instance(1).history;
    ASSERT_EQ(history.size(), 2U);
    EXPECT_EQ(history[0].frame, 10U);
    EXPECT_EQ(history[0].instance, 2U);
    EXPECT_EQ(history[0].other, 3U);
    EXPECT_EQ(history[1].instance, 1U);
    EXPECT_EQ(history[1].other, 2U);
    EXPECT_EQ(history[1].kind, InstanceEvent::Kind::merged);
}

TEST(InstanceViews, AfterASplitEachPartHasTheViewsThatLookedAtIt)
{
    SemanticVoxelMap map;
    map.categories().add("chair");
    Instance& whole = map.createInstance();
    const auto lookingAt = [&](float x, uint32_t frame) {
        InstanceView v = viewFrom(0, 100, frame);
        v.target.x = x;
        whole.views.add(0, v, MOST);
    };
    map.addEvidence({0, 0, 0}, 1, 1);   // at x = 0.025 m
    map.addEvidence({20, 0, 0}, 1, 1);  // at x = 1.025 m
    lookingAt(0.4F, 1);
    lookingAt(0.7F, 2);
    lookingAt(1.3F, 3);
    whole.decisions = {Decision()};
    whole.decisions[0].evidence = 4;
    const Instance& part = map.split(1, {{20, 0, 0}}, 0.25, 30);
    EXPECT_EQ(framesOf(map.instance(1).views, 0), (std::vector<uint32_t>{1}));
    EXPECT_EQ(framesOf(part.views, 0), (std::vector<uint32_t>{2, 3}));
    for (const Instance* i : std::vector<const Instance*>{&map.instance(1), &part}) {
        ASSERT_EQ(i->history.size(), 1U);
        EXPECT_EQ(i->history[0].kind, InstanceEvent::Kind::divided);
        EXPECT_EQ(i->history[0].frame, 30U);
        EXPECT_EQ(i->history[0].instance, 1U);
        EXPECT_EQ(i->history[0].other, 2U);
    }
    EXPECT_DOUBLE_EQ(map.instance(1).decisions.at(0).evidence, 3);
    EXPECT_DOUBLE_EQ(part.decisions.at(0).evidence, 1);
}

TEST(InstanceViews, TheHistoryIsBounded)
{
    SemanticVoxelMap map;
    map.createInstance();
    for (uint32_t i = 0; i < 200; ++i) map.merge(1, map.createInstance().id, i);
    const auto& history = map.instance(1).history;
    EXPECT_LE(history.size(), 100U);
    EXPECT_EQ(history.back().frame, 199U);
}
