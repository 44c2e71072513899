// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/errors.h"
#include "voxeland/datasets/ImageMatching.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
using Positions = std::vector<std::optional<size_t>>;
const std::optional<size_t> NONE;

std::vector<PredictedImage> named(const std::vector<std::string>& names)
{
    std::vector<PredictedImage> images;
    for (const auto& name : names) images.push_back({name, name, std::nullopt, 1});
    return images;
}

std::vector<PredictedImage> numbered(const std::vector<int64_t>& numbers)
{
    std::vector<PredictedImage> images;
    for (const auto n : numbers) images.push_back({std::to_string(n), "", n, 1});
    return images;
}

/** Frames numbered from 0 with these images. */
std::vector<DatasetFrame> framesWith(const std::vector<std::string>& images)
{
    std::vector<DatasetFrame> frames;
    for (const auto& image : images) frames.push_back({static_cast<int64_t>(frames.size()), image});
    return frames;
}

const std::vector<DatasetFrame> KITCHEN =
    framesWith({"seq-01/frame-000000.color.png", "seq-01/frame-000001.color.png"});
}  // namespace

TEST(ImageMatching, namesDecideHoweverTheyAreWritten)
{
    for (const std::string name :
         {"seq-01/frame-000001.color.png", "frame-000001.color.png", "frame-000001.color",
          "frame-000001.color.jpg", "/data/kitchen/seq-01/frame-000001.color.png",
          "C:\\data\\seq-01\\frame-000001.color.JPG", "./seq-01/frame-000001.color.png",
          "other/frame-000001.color.png", "frame-000001_color_jpg.rf.0123456789abcdef.jpg",
          "images/4/0f12ab9c-frame-000001.color.png", "SEQ-01/FRAME-000001.COLOR.PNG",
          "http://host:8080/data/frame-000001.color.jpg?d=a/b.c",
          "/data/local-files/?d=seq-01/frame-000001.color.jpg"})
    {
        const auto matching = matchImages(named({"unknown.png", name}), true, KITCHEN);
        EXPECT_EQ(matching.imageOf, (Positions{NONE, 1})) << name;
        EXPECT_EQ(matching.how, "by file name") << name;
        EXPECT_EQ(matching.doubt, "");
    }
}

TEST(ImageMatching, hashesOfLabellingProgramsAreRecognizedAlone)
{
    const auto isFrame = [](const std::string& name) {
        return matchImages(named({name}), true, KITCHEN).imageOf == Positions{NONE, 0};
    };
    EXPECT_TRUE(isFrame("frame-000001_color.rf.ab12.png"));
    EXPECT_TRUE(isFrame("frame-000001_color_jpeg.rf.AB12.rf.0"));
    EXPECT_FALSE(isFrame("frame-000001_color_gif.rf.ab12.png"));
    EXPECT_TRUE(isFrame("0f12ab9c-frame-000001.color.png"));
    EXPECT_FALSE(isFrame("0f12ab9-frame-000001.color.png"));
    EXPECT_FALSE(isFrame("0f12ab9cd-frame-000001.color.png"));
    EXPECT_FALSE(isFrame("0f12ab9g-frame-000001.color.png"));
}

TEST(ImageMatching, aNameOfAMegabyteIsOneAmongOthers)
{
    for (const std::string part : {".rf.", "a", ".", "_jpg.rf.a", "/", "0"}) {
        std::string name;
        while (name.size() < 1000000) name += part;
        const auto matching = matchImages(named({name, "frame-000001.color.png"}), true, KITCHEN);
        EXPECT_EQ(matching.imageOf, (Positions{NONE, 1})) << part;
    }
}

TEST(ImageMatching, foldersTellEqualNamesApart)
{
    const auto frames = framesWith({"seq-01/0.png", "seq-02/0.png", "seq-02/1.png"});
    const auto both = matchImages(named({"a/seq-02/0.jpg", "a/seq-01/0.jpg"}), true, frames);
    EXPECT_EQ(both.imageOf, (Positions{1, 0, NONE}));
    EXPECT_EQ(both.doubt, "");
    EXPECT_EQ(matchImages(named({"seq-02/0.jpg"}), true, frames).imageOf,
              (Positions{NONE, 0, NONE}))
        << "not the frame of another folder";
    const auto bare = matchImages(named({"0.jpg", "1.jpg"}), true, frames);
    EXPECT_EQ(bare.imageOf, (Positions{NONE, NONE, 1}));
    EXPECT_EQ(bare.doubt, "'0.jpg' may be several images: their folders would tell");
}

TEST(ImageMatching, otherNamesMatchInTheOrderOfTheList)
{
    const auto frames = framesWith({"INT_1.jpg", "INT_2.jpg", "INT_3.jpg"});
    auto images = named({"a", "b", "c"});
    images[0].number = 7;
    const auto matching = matchImages(images, true, frames);
    EXPECT_EQ(matching.imageOf, (Positions{0, 1, 2}));
    EXPECT_EQ(matching.how, "in the order of the file's images");
    EXPECT_EQ(matching.doubt, "");
    const auto fewer = matchImages(named({"x1", "x2"}), true, frames);
    EXPECT_EQ(fewer.imageOf, (Positions{0, 1, NONE}));
    EXPECT_EQ(fewer.doubt,
              "it lists 2 images for 3 frames: rgbd2rawlog --predictions matches by the "
              "dataset's own file names");
    const auto rooms = matchImages(named({"kitchen_2", "hall_1", "hall_2"}), true, frames);
    EXPECT_EQ(rooms.imageOf, (Positions{0, 1, 2}));
    EXPECT_EQ(rooms.doubt.find("the names of its images are in another order: rgbd2rawlog"), 0U);
}

TEST(ImageMatching, aListOutOfOrderIsRefused)
{
    const auto frames = framesWith({"INT_a.jpg", "INT_b.jpg", "INT_c.jpg"});
    const auto isRefused = [&](const std::vector<std::string>& names) {
        try {
            matchImages(named(names), true, frames);
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("rgbd2rawlog --predictions"), std::string::npos);
            return true;
        }
        return false;
    };
    EXPECT_TRUE(isRefused({"x12", "x11", "x13"}));
    EXPECT_TRUE(isRefused({"10.jpg", "100.jpg", "11.jpg"})) << "as ls lists them: 10, 100, 11";
    EXPECT_TRUE(isRefused({"1305.9.png", "1305.25.png", "1306.0.png"})) << "0.9 s, then 0.25 s";
    EXPECT_TRUE(isRefused({"f-01.png", "f-00.png"})) << "of three frames";
    EXPECT_TRUE(isRefused({"b/7.png", "b/9.png", "a/8.png", "a/6.png"}));
    EXPECT_FALSE(isRefused({"x9", "x10", "x100"}));
    EXPECT_FALSE(isRefused({"1305.25.png", "1305.9.png", "1306.0.png"}));
    EXPECT_FALSE(isRefused({"s-01/9.png", "s-02/1.png", "s-02/2.png"}));
    EXPECT_FALSE(isRefused({"f_jpg.rf.9.jpg", "f_jpg.rf.2.jpg", "f_jpg.rf.1.jpg"}));
    EXPECT_FALSE(isRefused({"", "", ""}));
    EXPECT_FALSE(isRefused({"INT_c.jpg", "9", "1"})) << "one is a frame's";
}

TEST(ImageMatching, aListOutOfOrderThatNumbersAllFramesIsMatchedByThem)
{
    const auto frames = framesWith({"INT_a.jpg", "INT_b.jpg", "INT_c.jpg"});
    const auto matching = matchImages(named({"x2", "x0", "x1"}), true, frames);
    EXPECT_EQ(matching.imageOf, (Positions{1, 2, 0}));
    EXPECT_EQ(matching.how, "by frame number");
}

TEST(ImageMatching, numbersThatMayCountFromOneAreDoubted)
{
    const auto frames = framesWith({"", "", "", "", ""});
    const auto doubts = [&](const std::vector<int64_t>& numbers) {
        return matchImages(numbered(numbers), false, frames).doubt;
    };
    EXPECT_NE(doubts({1, 2, 3, 4}).find("counted from 1"), std::string::npos);
    EXPECT_NE(doubts({1}).find("'images'"), std::string::npos);
    EXPECT_NE(doubts({2, 3, 4}), "") << "neither the first frame nor the last has any";
    EXPECT_EQ(doubts({3}), "") << "too few to miss 0";
    EXPECT_EQ(doubts({3, 4}), "") << "of five";
    EXPECT_EQ(doubts({0, 1, 2, 3}), "");
    EXPECT_EQ(doubts({1, 2, 3, 4, 5}), "") << "certain";
    EXPECT_EQ(matchImages(numbered({1, 2, 3, 4, 5}), false, frames).how,
              "by position, counted from 1");
    const std::vector<DatasetFrame> fromOne = {{1, ""}, {2, ""}, {3, ""}};
    EXPECT_EQ(matchImages(numbered({1, 2}), false, fromOne).doubt, "") << "the dataset's numbers";
}

TEST(ImageMatching, someOfTheImagesAreFoundByTheirNumbers)
{
    const auto frames = framesWith({"", "", "", ""});
    const auto matching = matchImages(named({"f-01.png", "f-03.png"}), true, frames);
    EXPECT_EQ(matching.imageOf, (Positions{NONE, 0, NONE, 1}));
    EXPECT_EQ(matching.how, "by frame number");
}

TEST(ImageMatching, numbersAreThoseOfFramesFirst)
{
    const std::vector<DatasetFrame> frames = {
        {0, "color/10.jpg"}, {1, "color/20.jpg"}, {2, "color/30.jpg"}};
    const auto check = [&](const std::vector<int64_t>& numbers, const Positions& expected,
                           const std::string& how) {
        const auto matching = matchImages(numbered(numbers), false, frames);
        EXPECT_EQ(matching.imageOf, expected) << how;
        EXPECT_EQ(matching.how, how);
    };
    check({2, 0}, {1, NONE, 0}, "by frame number");
    check({1, 2}, {NONE, 0, 1}, "by frame number");
    check({1, 2, 3}, {0, 1, 2}, "by position, counted from 1");
    check({30, 10}, {1, NONE, 0}, "by the number that is the image's file name");
    check({0, 3}, {0, NONE, NONE}, "by frame number");
    const std::vector<DatasetFrame> later = {{5, ""}, {6, ""}};
    EXPECT_EQ(matchImages(numbered({0, 1}), false, later).how, "by position, counted from 0");
    EXPECT_EQ(matchImages(numbered({5, 6}), false, later).how, "by frame number");
}

TEST(ImageMatching, aTextWithoutANameLikeItIsANumber)
{
    const auto frames = framesWith({"", "", ""});
    const auto matching =
        matchImages(named({"frame-000002.color", "frame-000000.color"}), false, frames);
    EXPECT_EQ(matching.imageOf, (Positions{1, NONE, 0}));
    EXPECT_NE(matching.doubt.find("rgbd2rawlog --predictions"), std::string::npos);
    auto numbered = named({"000002", "000000"});
    numbered[0].number = 2;
    numbered[1].number = 0;
    EXPECT_EQ(matchImages(numbered, false, frames).doubt, "");
}
