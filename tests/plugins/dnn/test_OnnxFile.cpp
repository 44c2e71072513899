// SPDX-License-Identifier: BSD-3-Clause
#include "OnnxFile.h"
#include "SmallOnnx.h"
#include "support/TestFiles.h"
#include "voxeland/errors.h"

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
