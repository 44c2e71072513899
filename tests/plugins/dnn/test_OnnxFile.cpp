// SPDX-License-Identifier: BSD-3-Clause
#include "OnnxFile.h"
#include "SmallOnnx.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
class OnnxFileTest : public testing::Test
{
 protected:
    [[nodiscard]] OnnxFile read(const std::string& content) const
    {
        writeFile(m_file, content);
        return OnnxFile(m_file);
    }
    [[nodiscard]] std::string errorOf(const std::string& content) const
    {
        try {
            (void)read(content);
        } catch (const InputError& e) {
            return e.what();
        }
        return "no error";
    }

    TemporaryFolder m_folder;
    std::string m_file = m_folder.file("model.onnx");
};

std::string model(const std::vector<int>& inputShape, const std::string& names = "")
{
    return smallOnnx({{"Relu", {"x"}, {"y"}}}, inputShape, names);
}
}  // namespace

TEST_F(OnnxFileTest, tellsTheSizeOfTheInput)
{
    EXPECT_EQ(read(model({1, 3, 480, 640})).input, cv::Size(640, 480));
    EXPECT_EQ(read(model({1, 3, 0, 0})).input, cv::Size());
    EXPECT_EQ(read(model({1, 3, 480, 0})).input, cv::Size());
    EXPECT_EQ(read(model({3, 480, 640})).input, cv::Size());
}

TEST_F(OnnxFileTest, tellsTheNamesOfTheClasses)
{
    using Names = std::vector<std::string>;
    EXPECT_EQ(read(model({1}, "{0: 'person', 1: \"bull's eye\", 2: 'wine glass'}")).classNames,
              (Names{"person", "bull's eye", "wine glass"}));
    EXPECT_EQ(read(model({1})).classNames, Names());
    EXPECT_EQ(read(model({1}, "{1: 'second', 0: 'first'}")).classNames, Names()) << "out of order";
    EXPECT_EQ(read(model({1}, "{\"0\": \"person\", \"1\": \"3d printer\"}")).classNames,
              (Names{"person", "3d printer"}));
    EXPECT_EQ(read(model({1}, "['mug', \"bull's eye\"]")).classNames, (Names{"mug", "bull's eye"}));
    EXPECT_EQ(read(model({1}, "{0: 'a: b', 1: '[c]'}")).classNames, (Names{"a: b", "[c]"}));
    EXPECT_EQ(read(model({1}, "['0: a']")).classNames, (Names{"0: a"}));
    for (const char* other : {"{}", "[]", "{\"a\": \"b\"}", "mug", "{0: 'a'", "['a", "{0 'a'}",
                              "{0: 'a', 1}", "{0: a}", "[", "{'0"})
        EXPECT_EQ(read(model({1}, other)).classNames, Names()) << other;
}

TEST_F(OnnxFileTest, aNameMayBeLong)
{
    const std::string name(2000000, 'a'), quoted = "'" + name + "'";
    EXPECT_EQ(read(model({1}, "{0: " + quoted + "}")).classNames.at(0), name);
    EXPECT_TRUE(read(model({1}, "{0: '" + name)).classNames.empty()) << "it has no end";
    EXPECT_TRUE(read(model({1}, "{" + std::string(2000000, '1') + ": 'a'}")).classNames.empty());
}

TEST_F(OnnxFileTest, namesTheOptionsOfTheExportThatMayHelp)
{
    using Options = std::vector<std::string>;
    const auto options = [this](const std::string& operation, const std::vector<int>& shape,
                                size_t type = ONNX_FLOAT) {
        return read(smallOnnx({{operation, {"x"}, {"y"}}}, shape, "", {{1}, type})).exportOptions;
    };
    const std::vector<int> usual = {1, 3, 64, 64};
    EXPECT_EQ(options("Relu", usual), Options());
    EXPECT_EQ(options("TopK", usual), (Options{"nms=False", "end2end=False"}));
    EXPECT_EQ(options("NonMaxSuppression", usual), (Options{"nms=False", "end2end=False"}));
    EXPECT_EQ(options("Relu", usual, ONNX_FLOAT16), Options{"half=False"});
    EXPECT_EQ(options("QLinearConv", usual), Options{"int8=False"});
    EXPECT_EQ(options("DequantizeLinear", usual), Options{"int8=False"});
    EXPECT_EQ(options("Relu", {0, 3, 64, 64}), Options{"dynamic=False"});
    EXPECT_EQ(options("Relu", {1, 3, 0, 0}), Options{"dynamic=False"});
    EXPECT_EQ(options("Relu", {4, 3, 64, 64}), Options{"batch=1"});
    EXPECT_EQ(options("TopK", {0, 3, 64, 64}, ONNX_FLOAT16),
              (Options{"nms=False", "end2end=False", "half=False", "dynamic=False"}));
}

TEST_F(OnnxFileTest, weightsInAnotherFileAreRefused)
{
    const std::string error =
        errorOf(smallOnnx({{"Add", {"x", "c"}, {"y"}}}, {1}, "", {{1}, ONNX_FLOAT, true}));
    EXPECT_NE(error.find("save it as one file"), std::string::npos) << error;
    EXPECT_NE(error.find(m_file), std::string::npos) << error;
}

TEST_F(OnnxFileTest, saysWhatIsWrongWithAFile)
{
    const std::string whole = model({1, 3, 480, 640}, "{0: 'person'}");
    EXPECT_NE(errorOf(whole.substr(0, whole.size() - 1)).find("cut off"), std::string::npos);
    EXPECT_NE(errorOf(whole.substr(0, whole.size() / 2)).find("cut off"), std::string::npos);
    for (const char* text : {"", "hello\n", "<html>not found</html>"})
        EXPECT_NE(errorOf(text).find("is not an ONNX model"), std::string::npos) << text;
    EXPECT_THROW(OnnxFile(m_folder.file("missing.onnx")), InputError);
}
