// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/CategoryNames.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(CategoryNames, knowsCocosNumbers)
{
    const auto& names = cocoCategoryNames();
    EXPECT_EQ(names.size(), 91U);
    for (const auto& [id, name] : CategoryNames{{1, "person"},
                                                {44, "bottle"},
                                                {62, "chair"},
                                                {63, "couch"},
                                                {65, "bed"},
                                                {67, "dining table"},
                                                {70, "toilet"},
                                                {72, "tv"},
                                                {82, "refrigerator"},
                                                {84, "book"},
                                                {90, "toothbrush"}})
        EXPECT_EQ(names.at(id), name);
}

TEST(CategoryNames, readsEveryForm)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("names");
    const CategoryNames expected = {{0, "cup"}, {1, "wine glass"}};
    for (const char* text :
         {"id,name\r\n0,cup\r\n1,wine glass\r\n",
          "0,cup\n1,wine glass",
          R"({"categories": [{"id": 1, "name": "wine glass"}, {"id": 0, "name": "cup"}]})",
          R"([{"id": 1, "name": "wine glass"}, {"id": 0, "name": "cup"}])",
          R"( ["cup", "wine glass"])",
          "\xEF\xBB\xBF"
          "0,cup\r\n1,wine glass",
          "0;cup\n1;wine glass",
          "0\tcup\n1\twine glass",
          "0, cup \n\n1,\"wine glass\"\n",
          "0,cup,kitchen\n1,wine glass,kitchen",
          "name,index\ncup,0\nwine glass,1\n",
          "cup\nwine glass\n",
          "name\ncup\nwine glass\n",
          "name,class\nmug,cup\ncup,cup\nglass,wine glass\n",
          "name,kind\ncup,dish\nwine glass,dish\n",
          "sep=;\r\nid;name\r\n0;cup\r\n1;wine glass\r\n",
          "id,name\r0,cup\r1,wine glass\r",
          "id,name\n0,\xC2\xA0"
          "cup\xC2\xA0 \n1,wine glass\xC2\xA0\n",
          "0 cup\n1 wine glass\n",
          "0: cup\n1: wine glass\n",
          "\xEF\xBB\xBF[\"cup\", \"wine glass\"]",
          R"({"0": "cup", "1": "wine glass"})",
          R"({"cup": 0, "wine glass": 1})",
          R"({"names": ["cup", "wine glass"]})",
          R"({"id2label": {"0": "cup", "1": "wine glass"}})",
          "path: ../a\nnames:\n  0: cup\n  1: wine glass  # for wine\nnc: 2\n",
          "names:\n- cup\n- 'wine glass'\n\nnc: 2\n",
          "nc: 2\r\nnames: [cup, \"wine glass\"]\r\n",
          "names: {0: cup,\n  1: wine glass}\n"})
    {
        test::writeFile(file, text);
        EXPECT_EQ(readCategoryNames(file), expected) << text;
    }
}

TEST(CategoryNames, refusesALineByItsNumber)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("names");
    for (const auto& [text, line] :
         std::map<std::string, int>{{"0,cup\n\nx,glass\n", 3},
                                    {"id,name\n0,cup\n1\n", 3},
                                    {"id,name\ncup,cup\n", 2},
                                    {"name,kind\ncup,dish\n,dish\n", 3},
                                    {"0,cup\n1,\n", 2},
                                    {"0,cup\n0,glass\n", 2},
                                    {"0,cup\n1,gl\xE4sser\n", 2},
                                    {"0,\"cup\n1,glass\n", 1},
                                    {"item {\n  id: 1\n}\n", 1},
                                    {"names:\n  0: cup\n  glass\n", 3},
                                    {"names:\n  0: cup\n  0: glass\n", 3},
                                    {"nc: 1\nnames: cups.txt\n", 2},
                                    {"nc: 1\nnames: [cup,\n glass\n", 2}})
    {
        test::writeFile(file, text);
        try {
            readCategoryNames(file);
            ADD_FAILURE() << text;
        } catch (const InputError& e) {
            EXPECT_EQ(std::string(e.what()).find("line " + std::to_string(line) + " of " + file),
                      0U)
                << text << e.what();
        }
    }
}

TEST(CategoryNames, refusesWhatNamesNothing)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("names");
    EXPECT_THROW(readCategoryNames(file), InputError);
    for (const char* text : {"", "[]", R"({"things": []})", R"([{"id": "one"}])",
                             R"([{"id": 1, "name": 2}])", "[1, 2]", R"(["cup",)"})
    {
        test::writeFile(file, text);
        EXPECT_THROW(readCategoryNames(file), InputError) << text;
    }
}

TEST(CategoryNames, cocosEightyAreNumberedFromZero)
{
    const auto names = readCategoryNames(std::string(VOXELAND_LABELS) + "/coco80.csv");
    EXPECT_EQ(names.size(), 80U);
    for (const auto& [id, name] : CategoryNames{
             {0, "person"}, {39, "bottle"}, {56, "chair"}, {62, "tv"}, {79, "toothbrush"}})
        EXPECT_EQ(names.at(id), name);
}

TEST(CategoryNames, shippedTablesAreThoseOfNyuAndScanNet)
{
    const std::string folder = VOXELAND_LABELS;
    const auto nyu = readCategoryNames(folder + "/nyu40.csv");
    EXPECT_EQ(nyu.size(), 40U);
    for (const auto& [id, name] : CategoryNames{{5, "chair"},
                                                {7, "table"},
                                                {24, "refridgerator"},
                                                {33, "toilet"},
                                                {37, "bag"},
                                                {40, "otherprop"}})
        EXPECT_EQ(nyu.at(id), name);
    const auto scannet = readCategoryNames(folder + "/scannet20.csv");
    EXPECT_EQ(scannet.size(), 20U);
    for (const auto& [id, name] : scannet) EXPECT_EQ(nyu.at(id), name);
}
