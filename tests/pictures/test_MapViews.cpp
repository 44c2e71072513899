// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/Colors.h"
#include "pictures/MapViews.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"
#include "voxeland/exporters/ExportAll.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

using namespace voxeland;
using voxeland::test::TemporaryFolder;

namespace
{
constexpr int HEIGHT = 400;
const mrpt::math::TVector3D UP(0, 0, 1);

const std::vector<std::string> NAMES = {"instances_top.png",
                                        "instances_perspective.png",
                                        "categories_top.png",
                                        "categories_perspective.png",
                                        "uncertainty_instances_top.png",
                                        "uncertainty_instances_perspective.png",
                                        "uncertainty_categories_top.png",
                                        "uncertainty_categories_perspective.png",
                                        "uncertainty_semantic_top.png",
                                        "uncertainty_semantic_perspective.png"};

/** A floor of 40 x 20 voxels with an object on its left (sure of being a chair) and one on its
 *  right (either of two), under a ceiling. */
SemanticVoxelMap room()
{
    MapOptions options;
    options.resolution = test::TINY_RESOLUTION;
    options.prior_strength = 0;
    SemanticVoxelMap map(options);
    const auto left = test::addInstance(map, {{"chair", 5}});
    const auto right = test::addInstance(map, {{"table", 1}, {"bed", 1}});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) {
            test::addVoxel(map, {x, y, 0}, {{UNKNOWN_INSTANCE, 1}});
            test::addVoxel(map, {x, y, 24}, {{UNKNOWN_INSTANCE, 1}});
            if (y < 5 || y >= 15) continue;
            if (x >= 5 && x < 15) test::addVoxel(map, {x, y, 5}, {{left, 3}});
            if (x >= 25 && x < 35) test::addVoxel(map, {x, y, 5}, {{right, 3}});
        }
    return map;
}

cv::Mat3b viewOf(const SemanticVoxelMap& map, const std::string& name,
                 const mrpt::math::TVector3D& up = UP)
{
    const TemporaryFolder folder;
    ViewOptions options;
    options.height = HEIGHT;
    options.up = up;
    WrittenFiles written;
    exportViews(map, folder.path().string(), written, options);
    return cv::imread(folder.file(name));
}

/** Pixels of the picture, not the legend, that have just this colour. */
std::vector<cv::Point> pixelsOf(const cv::Mat3b& image, const Color& color)
{
    std::vector<cv::Point> pixels;
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.cols * 7 / 10; ++column)
            if (image(row, column) == cv::Vec3b(color.blue, color.green, color.red))
                pixels.emplace_back(column, row);
    return pixels;
}

cv::Point2d middleOf(const std::vector<cv::Point>& pixels)
{
    cv::Point2d sum(0, 0);
    for (const cv::Point& p : pixels) sum += cv::Point2d(p);
    return sum / static_cast<double>(std::max<size_t>(1, pixels.size()));
}
}  // namespace

TEST(MapViews, writesTenPicturesOfTheSizeAskedFor)
{
    const TemporaryFolder folder;
    ViewOptions options;
    options.height = HEIGHT;
    WrittenFiles written;
    exportViews(room(), folder.file("new/folder"), written, options);
    const auto& files = written.names();
    ASSERT_EQ(files.size(), NAMES.size());
    for (size_t i = 0; i < NAMES.size(); ++i) {
        EXPECT_EQ(files[i], folder.file("new/folder") + "/" + NAMES[i]);
        EXPECT_EQ(cv::imread(files[i]).size(), cv::Size(HEIGHT * 3 / 2, HEIGHT)) << NAMES[i];
    }
}

/** The scene is 40 voxels wide: its objects' middles are 20 voxels apart, half its width. */
TEST(MapViews, topViewIsToScaleAndTheCeilingIsOpen)
{
    const cv::Mat3b image = viewOf(room(), "instances_top.png");
    const auto left = pixelsOf(image, instanceColors(room()).at(1)),
               right = pixelsOf(image, instanceColors(room()).at(2));
    ASSERT_GT(left.size(), 500U);
    EXPECT_NEAR(static_cast<double>(left.size()), static_cast<double>(right.size()),
                0.1 * static_cast<double>(left.size()));
    const cv::Point2d apart = middleOf(right) - middleOf(left);
    const double voxel = std::sqrt(static_cast<double>(left.size()) / 100);  // 10 x 10 voxels
    EXPECT_NEAR(apart.x / voxel, 20, 1.5);
    EXPECT_NEAR(apart.y, 0, 1);
}

TEST(MapViews, yPointsUpInTheTopView)
{
    SemanticVoxelMap map = room();
    const auto far = test::addInstance(map, {{"cup", 1}});
    for (int x = 16; x < 24; ++x)
        for (int y = 16; y < 20; ++y) test::addVoxel(map, {x, y, 5}, {{far, 3}});
    const cv::Mat3b image = viewOf(map, "instances_top.png");
    EXPECT_LT(middleOf(pixelsOf(image, instanceColors(map).at(far))).y,
              middleOf(pixelsOf(image, instanceColors(map).at(1))).y - 10);
}

/** The scale ends at the right object's entropies: the expected one of (1,1), 0.5, is the largest
 *  of instances and categories. */
TEST(MapViews, uncertaintyIsBlueWhereSureAndRedWhereNot)
{
    const cv::Mat3b image = viewOf(room(), "uncertainty_categories_top.png");
    const auto sure = pixelsOf(image, uncertaintyColor(0)),
               unsure = pixelsOf(image, uncertaintyColor(1));
    ASSERT_GT(sure.size(), 500U);
    ASSERT_GT(unsure.size(), 500U);
    EXPECT_LT(middleOf(sure).x, middleOf(unsure).x);
}

/** An entropy of 0.5 over instances has the colour of 0.5 over categories, the end of the scale. */
TEST(MapViews, allUncertaintiesHaveOneScale)
{
    SemanticVoxelMap map = room();
    const auto shared = test::addInstance(map, {{"cup", 1}});
    for (int x = 16; x < 24; ++x)
        for (int y = 6; y < 14; ++y)
            test::addVoxel(map, {x, y, 5}, {{shared, 2}, {UNKNOWN_INSTANCE, 1}});
    // Dirichlet (2,1): 2/3 (psi(4) - psi(3)) + 1/3 (psi(4) - psi(2)) = 2/3 1/3 + 1/3 (1/3 + 1/2)
    const Color color = uncertaintyColor((2.0 / 9 + 5.0 / 18) / 0.5);
    EXPECT_GT(pixelsOf(viewOf(map, "uncertainty_instances_top.png"), color).size(), 200U);
}

TEST(MapViews, upTurnsTheScene)
{
    // Seen along -x, the two objects lie behind each other and are one voxel high.
    const cv::Mat3b image = viewOf(room(), "instances_top.png", {1, 0, 0});
    EXPECT_LT(pixelsOf(image, instanceColors(room()).at(1)).size(), 100U);
}

TEST(MapViews, drawsTheSameTwice)
{
    for (const char* name : {"instances_perspective.png", "uncertainty_semantic_perspective.png"})
        EXPECT_EQ(cv::norm(viewOf(room(), name), viewOf(room(), name)), 0);
}

TEST(MapViews, emptyMapsHaveEmptyPictures)
{
    EXPECT_FALSE(viewOf(SemanticVoxelMap(), "instances_perspective.png").empty());
    EXPECT_FALSE(viewOf(test::tinyMap(), "instances_perspective.png").empty());
}

TEST(MapViews, refusesWhatItCannotDo)
{
    const TemporaryFolder folder;
    test::writeFile(folder.file("file"), "");
    WrittenFiles written;
    EXPECT_THROW(exportViews(room(), folder.file("file"), written), OutputError);
    EXPECT_THROW(exportViews(room(), folder.file("file/below"), written), OutputError);
    ViewOptions options;
    options.up = mrpt::math::TVector3D(0, 0, 0);
    EXPECT_THROW(exportViews(room(), folder.file("a"), written, options), ConfigurationError);
    options = ViewOptions();
    options.height = 10;
    EXPECT_THROW(exportViews(room(), folder.file("a"), written, options), ConfigurationError);
}

TEST(ExportAll, writesEverythingAndSaysSo)
{
    const TemporaryFolder folder;
    WrittenFiles written;
    exportAll(test::tinyMap(), folder.file("out"), written);
    const auto& files = written.names();
    EXPECT_EQ(files.size(), 3 + NAMES.size());
    for (const std::string& f : files) EXPECT_TRUE(std::filesystem::is_regular_file(f)) << f;
    const auto there = std::distance(std::filesystem::directory_iterator(folder.file("out")), {});
    EXPECT_EQ(static_cast<size_t>(there), files.size());
}

TEST(ExportAll, tellsWhichFilesAreCompleteWhenOneFails)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("out/categories_top.png"));
    WrittenFiles written;
    try {
        exportAll(test::tinyMap(), folder.file("out"), written);
        FAIL() << "no exception";
    } catch (const OutputError& e) {
        const std::string what = e.what();
        EXPECT_NE(what.find("categories_top.png: it is a folder"), std::string::npos) << what;
        EXPECT_NE(what.find("; complete: map.ply, instances.json, instances.csv and "),
                  std::string::npos)
            << what;
    }
    for (const std::string& file : written.names())
        EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
}
