// SPDX-License-Identifier: BSD-3-Clause
#include "ClassNames.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;
using Names = std::vector<std::string>;

TEST(ClassNames, readsTheShippedTables)
{
    const std::string folder = VOXELAND_LABELS;
    const Names coco80 = readClassNames(folder + "/coco80.csv");
    ASSERT_EQ(coco80.size(), 80u);
    EXPECT_EQ(coco80[0], "person");
    EXPECT_EQ(coco80[41], "cup");
    EXPECT_EQ(coco80[56], "chair");
    EXPECT_EQ(coco80[79], "toothbrush");
    const Names coco91 = readClassNames(folder + "/coco91.csv");
    ASSERT_EQ(coco91.size(), 91u);
    EXPECT_EQ(coco91[0], "person");
    EXPECT_EQ(coco91[61], "chair");
}

TEST(ClassNames, readsEveryForm)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("names");
    const auto read = [&](const std::string& text) {
        test::writeFile(file, text);
        return readClassNames(file);
    };
    EXPECT_EQ(read("cup\r\nwine glass\n\n"), (Names{"cup", "wine glass"}));
    EXPECT_EQ(read("id,name\n1,cup\n3,fork\n"), (Names{"cup", "", "fork"}));
    EXPECT_EQ(read(R"(["cup", "fork"])"), (Names{"cup", "fork"}));
    EXPECT_EQ(read("name,class\nmug,cup\nfork,fork\ncup,cup\n"), (Names{"cup", "fork"}));
    EXPECT_THROW(read(""), InputError);
    EXPECT_THROW(read("some, text"), InputError);
    EXPECT_THROW(read("1,one\n1000000000,huge\n"), InputError);
    EXPECT_THROW(readClassNames(folder.file("missing")), InputError);
}
