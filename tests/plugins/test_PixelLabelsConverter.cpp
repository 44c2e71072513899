// SPDX-License-Identifier: BSD-3-Clause
#include "support/ConfiguredPlugin.h"
#include "support/Frames.h"
#include "voxeland/observations/VoxelizedFrame.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::test;
using mrpt::obs::TPixelLabelInfo;

namespace
{
std::shared_ptr<COpinionConverter> converter(const std::string& keys = "")
{
    return configuredPlugin<COpinionConverter>("pixel_labels", "CPixelLabelsConverter", keys);
}

/** A scan of a wall whose pixels may have labels of so many bytes. */
template <unsigned int BYTES>
std::shared_ptr<mrpt::obs::CObservation3DRangeScan> labelledScan()
{
    auto scan = makeScan([](int, int) { return 1.52; });
    auto labels = std::make_shared<TPixelLabelInfo<BYTES>>();
    labels->setSize(ROWS, COLUMNS);
    scan->pixelLabels = labels;
    return scan;
}

/** Gives a label to the columns [left, right) and rows [top, bottom). */
void label(mrpt::obs::CObservation3DRangeScan& scan, uint8_t number, int left, int top, int right,
           int bottom)
{
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column)
            scan.pixelLabels->setLabel(row, column, number);
}
}  // namespace

TEST(PixelLabelsConverter, eachConnectedRegionOfALabelIsAnObject)
{
    const auto scan = labelledScan<1>();
    scan->pixelLabels->setLabelName(0, "table");
    scan->pixelLabels->setLabelName(3, "cup");
    label(*scan, 3, 0, 0, 10, 10);
    label(*scan, 3, 10, 10, 20, 20);  // touches the first by a corner
    label(*scan, 3, 40, 0, 50, 10);
    label(*scan, 0, 45, 5, 60, 30);  // overlaps the one before
    label(*scan, 3, 70, 0, 77, 7);   // 49 pixels
    const auto found = converter("min_pixels = 50\nscore = 0.5\n")->predict(*scan);
    EXPECT_EQ(found->imageWidth, COLUMNS);
    EXPECT_EQ(found->imageHeight, ROWS);
    ASSERT_EQ(found->instances.size(), 3u);
    const auto expectRegion = [&](size_t i, const std::string& name, uint64_t area, int left,
                                  int width) {
        const InstancePrediction& p = found->instances[i];
        EXPECT_EQ(p.categories, (CategoryDistribution{{name, 1}}));
        EXPECT_EQ(p.mask.area(), area);
        EXPECT_EQ(p.box.x, left);
        EXPECT_EQ(p.box.width, width);
        EXPECT_EQ(p.score, 0.5F);
        EXPECT_EQ(p.track, InstancePrediction::NO_TRACK);
    };
    expectRegion(0, "table", 15 * 25, 45, 15);
    expectRegion(1, "cup", 200, 0, 20);
    expectRegion(2, "cup", 100, 40, 10);
    EXPECT_EQ(converter("min_pixels = 49\n")->predict(*scan)->instances.size(), 4u);
}

TEST(PixelLabelsConverter, asManyLabelsAsMrptHas)
{
    const auto scan = labelledScan<8>();
    scan->pixelLabels->setLabelName(63, "last");
    label(*scan, 63, 0, 0, 10, 10);
    label(*scan, 31, 20, 0, 30, 10);  // has no name: nobody could say what it is
    const auto found = converter()->predict(*scan);
    ASSERT_EQ(found->instances.size(), 1u);
    EXPECT_EQ(found->instances[0].categories[0].name, "last");
}

TEST(PixelLabelsConverter, regionsBecomeOpinions)
{
    RgbdFrame frame;
    const auto scan = labelledScan<2>();
    scan->pixelLabels->setLabelName(9, "sofa");
    label(*scan, 9, 30, 10, 50, 30);
    frame.scan = scan;
    frame.instances = converter()->predict(*scan);
    const auto opinions = converter()->convert(frame, VoxelizedFrame(frame, 0.05, {}));
    ASSERT_EQ(opinions.size(), 1u);
    EXPECT_EQ(opinions[0].categories[0].name, "sofa");
    float points = 0;
    for (const auto& v : opinions[0].voxels) points += v.points;
    EXPECT_EQ(points, 400);
}

TEST(PixelLabelsConverter, aScanWithoutLabelsHasNoPredictions)
{
    const auto scan = makeScan([](int, int) { return 1.52; });
    EXPECT_EQ(converter()->predict(*scan), nullptr);
}
