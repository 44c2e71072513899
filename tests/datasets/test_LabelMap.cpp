// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/LabelMap.h"

#include <gtest/gtest.h>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
using voxeland::test::writeFile;

namespace
{
std::string classNameOf(const LabelMap& map, const std::string& name)
{
    const class_id_t c = map.classOf(name);
    return c == NO_CLASS ? "none" : map.classes().at(static_cast<size_t>(c));
}

std::string failureOf(const std::string& content)
{
    const TemporaryFolder folder;
    writeFile(folder.file("l.csv"), content);
    try {
        LabelMap::fromFile(folder.file("l.csv"));
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find(folder.file("l.csv")), std::string::npos);
        return e.what();
    }
    return "";
}
}  // namespace

TEST(LabelMap, paper9KnowsCocoAndNyuNames)
{
    const LabelMap map = LabelMap::paper9();
    EXPECT_EQ(map.classes(),
              (std::vector<std::string>{"bed", "chair", "sofa", "table", "books", "refrigerator",
                                        "television", "toilet", "bag"}));
    EXPECT_EQ(classNameOf(map, "couch"), "sofa");
    EXPECT_EQ(classNameOf(map, "dining table"), "table");
    EXPECT_EQ(classNameOf(map, "Dining_Table"), "table");
    EXPECT_EQ(classNameOf(map, "book"), "books");
    EXPECT_EQ(classNameOf(map, "tv"), "television");
    EXPECT_EQ(classNameOf(map, "refridgerator"), "refrigerator") << "as NYU40 spells it";
    for (const char* name : {"backpack", "handbag", "suitcase", "bag"})
        EXPECT_EQ(classNameOf(map, name), "bag");
    EXPECT_EQ(classNameOf(map, "desk"), "none");
    EXPECT_EQ(classNameOf(map, "unknown"), "none");
}

TEST(LabelMap, shippedFilesAreValid)
{
    const std::string folder = VOXELAND_LABELS;
    EXPECT_EQ(LabelMap::fromFile(folder + "/paper9.csv").classes(), LabelMap::paper9().classes());
    EXPECT_EQ(LabelMap::fromFile(folder + "/scannet18.csv").classes().size(), 18U);
    EXPECT_EQ(LabelMap::fromFile(folder + "/paper_scannet.csv").classes().size(), 10U);
    EXPECT_EQ(LabelMap::fromFile(folder + "/coco80.csv").classes().size(), 80U);
}

TEST(LabelMap, readsQuotedNamesAndWindowsLines)
{
    const TemporaryFolder folder;
    writeFile(folder.file("l.csv"), "name,class\r\n\"table, round\",table\r\n\r\nstool,seat\r\n");
    const LabelMap map = LabelMap::fromFile(folder.file("l.csv"));
    EXPECT_EQ(classNameOf(map, "table, round"), "table");
    EXPECT_EQ(classNameOf(map, "stool"), "seat");
}

TEST(LabelMap, saysWhatIsWrongWithAFile)
{
    EXPECT_NE(failureOf("a,b\nbed,bed\n").find("name,class"), std::string::npos);
    EXPECT_NE(failureOf("name,class\nbed\n").find("line 2"), std::string::npos);
    EXPECT_NE(failureOf("name,class\nbed,bed\nBED,sofa\n").find("two classes"), std::string::npos);
    EXPECT_NE(failureOf("name,class\n").find("no class"), std::string::npos);
    EXPECT_NE(failureOf("").find("name,class"), std::string::npos);
    EXPECT_THROW(LabelMap::fromFile("/no/such/file.csv"), InputError);
}
