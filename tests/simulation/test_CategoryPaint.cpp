// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/CategoryPaint.h"
#include "voxeland/simulation/Simulator.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace voxeland::simulation;

namespace
{
std::string categoryOf(int red, int green, int blue)
{
    const std::string* name = categoryOfPaint(
        static_cast<uint8_t>(red), static_cast<uint8_t>(green), static_cast<uint8_t>(blue));
    return name == nullptr ? "none" : *name;
}
}  // namespace

TEST(CategoryPaint, isRecognisedInAnyLight)
{
    for (const std::string& category : paintedCategories()) {
        const Colour paint = paintOf(category);
        for (const float light : {0.4F, 0.7F, 1.0F}) {
            const auto byte = [light](float c) { return static_cast<int>(255 * light * c); };
            EXPECT_EQ(categoryOf(byte(paint.r), byte(paint.g), byte(paint.b)), category);
        }
    }
    EXPECT_THROW((void)paintOf("giraffe"), std::out_of_range);
}

TEST(CategoryPaint, greysAndPaleColoursAreNoPaint)
{
    EXPECT_EQ(categoryOf(200, 200, 200), "none");
    EXPECT_EQ(categoryOf(200, 120, 60), "none") << "wood";
    EXPECT_EQ(categoryOf(40, 0, 0), "none") << "too dark to tell";
    EXPECT_NE(categoryOf(200, 0, 0), "none");
}

TEST(CategoryPaint, aPaintedApartmentShowsItsCategoriesAndNothingElseDoes)
{
    SimulationOptions options;
    options.scene.rooms = 3;
    options.scene.painted = true;
    options.camera.frames = 12;
    options.camera.width = 320;
    options.camera.height = 240;
    for (const uint64_t seed : {1U, 2U}) {
        options.seed = seed;
        const Simulator simulator(options);
        size_t objectPixels = 0;
        for (size_t f = 0; f < simulator.size(); ++f) {
            const RenderedView view = simulator.frame(f).exact;
            for (size_t i = 0; i < view.objects.size(); ++i) {
                const bool isObject = view.objects[i] != STRUCTURE;
                const std::string expected =
                    isObject ? simulator.scene().object(view.objects[i]).category : "none";
                ASSERT_EQ(categoryOf(view.bgr[3 * i + 2], view.bgr[3 * i + 1], view.bgr[3 * i]),
                          expected);
                objectPixels += isObject ? 1 : 0;
            }
        }
        EXPECT_GT(objectPixels, 100000U);
    }
}

TEST(CategoryPaint, changesNothingButColours)
{
    SimulationOptions options;
    options.camera.frames = 4;
    const SimulatedFrame natural = Simulator(options).frame(2);
    options.scene.painted = true;
    const SimulatedFrame painted = Simulator(options).frame(2);
    EXPECT_EQ(natural.depth, painted.depth);
    EXPECT_EQ(natural.exact.objects, painted.exact.objects);
    EXPECT_NE(natural.exact.bgr, painted.exact.bgr);
    ASSERT_EQ(natural.predictions.size(), painted.predictions.size());
    for (size_t i = 0; i < natural.predictions.size(); ++i)
        EXPECT_EQ(natural.predictions[i].categories, painted.predictions[i].categories);
}
