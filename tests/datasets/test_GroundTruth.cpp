// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/GroundTruth.h"

#include <gtest/gtest.h>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
using voxeland::test::writeFile;

namespace
{
const std::string CATEGORIES = "index,name\n0,wall\n3,chair\n7,\"sink, steel\"\n";
const std::string PROPERTIES =
    "property float x\nproperty float y\nproperty float z\n"
    "property uint instance\nproperty int category\n";

std::string asciiPly(const std::string& vertices, int count,
                     const std::string& properties = PROPERTIES)
{
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
           "end_header\n" + vertices;
}

template <typename T>
std::string raw(T value)
{
    return std::string(reinterpret_cast<const char*>(&value), sizeof(T));
}

GroundTruth read(const std::string& ply, const std::string& categories = CATEGORIES)
{
    const TemporaryFolder folder;
    writeFile(folder.file("ground_truth.ply"), ply);
    writeFile(folder.file("categories.csv"), categories);
    return readGroundTruth(folder.path().string(), "ply");
}

std::string failureOf(const std::string& ply, const std::string& categories = CATEGORIES)
{
    try {
        read(ply, categories);
    } catch (const InputError& e) {
        const std::string text = e.what();
        EXPECT_EQ(text.find('\n'), std::string::npos) << "one sentence";
        return text;
    }
    return "";
}

void expectIn(const std::string& part, const std::string& text)
{
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}
}  // namespace

TEST(PlyGroundTruth, readsAscii)
{
    const GroundTruth gt = read(asciiPly("1 2.5 -3 4 3\n0.5 0 0 0 99\n7 8 9 2 7\n", 3));
    ASSERT_EQ(gt.points.size(), 3U);
    EXPECT_EQ(gt.points[0].y, 2.5F);
    EXPECT_EQ(gt.points[0].z, -3);
    EXPECT_EQ(gt.instance, (std::vector<uint32_t>{4, 0, 2}));
    EXPECT_EQ(gt.names.at(gt.category[0]), "chair");
    EXPECT_EQ(gt.names.at(gt.category[2]), "sink, steel");
}

TEST(PlyGroundTruth, readsBinaryInAnyOrderAndSkipsTheRest)
{
    std::string ply =
        "ply\r\nformat binary_little_endian 1.0\r\ncomment made by hand\r\nelement camera 2\r\n"
        "property uchar a\r\nproperty list uchar short b\r\nelement vertex 2\r\n"
        "property uchar category\r\nproperty double z\r\nproperty list uchar int c\r\n"
        "property short instance\r\nproperty float x\r\nproperty uchar red\r\n"
        "property float y\r\nelement face 9\r\nproperty list uchar int vertex_indices\r\n"
        "end_header\r\n";
    ply.erase(ply.rfind('\r'), 1);  // a header of mixed line ends
    ply += raw(uint8_t{1}) + raw(uint8_t{2}) + raw(int16_t{5}) + raw(int16_t{6});
    ply += raw(uint8_t{1}) + raw(uint8_t{0});
    ply += raw(uint8_t{3}) + raw(1.5) + raw(uint8_t{1}) + raw(int32_t{77}) + raw(int16_t{300}) +
           raw(0.25F) + raw(uint8_t{200}) + raw(-0.5F);
    ply += raw(uint8_t{7}) + raw(-1e-3) + raw(uint8_t{0}) + raw(int16_t{-1}) + raw(1.F) +
           raw(uint8_t{0}) + raw(2.F);
    const GroundTruth gt = read(ply);
    ASSERT_EQ(gt.points.size(), 2U);
    EXPECT_EQ(gt.points[0], mrpt::math::TPoint3D(0.25, -0.5, 1.5));
    EXPECT_EQ(gt.points[1], mrpt::math::TPoint3D(1, 2, -1e-3));
    EXPECT_EQ(gt.instance, (std::vector<uint32_t>{300, 0})) << "negative: none";
    EXPECT_EQ(gt.names.at(gt.category[0]), "chair");
}

TEST(PlyGroundTruth, takesTheFileItselfToo)
{
    const TemporaryFolder folder;
    writeFile(folder.file("room.ply"), asciiPly("1 2 3 4 3\n", 1));
    writeFile(folder.file("categories.csv"), CATEGORIES);
    EXPECT_EQ(readPlyGroundTruth(folder.file("room.ply")).points.size(), 1U);
}

TEST(PlyGroundTruth, saysWhatIsMissing)
{
    const TemporaryFolder folder;
    try {
        readPlyGroundTruth(folder.path().string());
        FAIL() << "no exception";
    } catch (const InputError& e) {
        expectIn(folder.file("ground_truth.ply"), e.what());
    }
    writeFile(folder.file("ground_truth.ply"), asciiPly("1 2 3 4 3\n", 1));
    try {
        readPlyGroundTruth(folder.path().string());
        FAIL() << "no exception";
    } catch (const InputError& e) {
        expectIn(folder.file("categories.csv"), e.what());
    }
    EXPECT_THROW(readGroundTruth(folder.path().string(), "obj"), ConfigurationError);
}

TEST(PlyGroundTruth, saysWhatIsWrongWithTheFile)
{
    expectIn("is not a PLY file", failureOf(""));
    expectIn("is not a PLY file", failureOf("solid cube\n"));
    expectIn("ends within its header", failureOf("ply\nformat ascii 1.0\n"));
    expectIn("binary_big_endian", failureOf("ply\nformat binary_big_endian 1.0\nend_header\n"));
    expectIn("has no element 'vertex'", failureOf("ply\nformat ascii 1.0\nend_header\n"));
    expectIn("has no vertex property 'instance'",
             failureOf(
                 asciiPly("1 2 3\n", 1, "property float x\nproperty float y\nproperty float z\n")));
    expectIn("unknown type 'real'", failureOf(asciiPly("1\n", 1, "property real x\n")));
    expectIn("an integer as vertex property 'category'",
             failureOf(asciiPly("1 2 3 4 3\n", 1,
                                "property float x\nproperty float y\nproperty float z\n"
                                "property int instance\nproperty float category\n")));
    expectIn("no vertices", failureOf(asciiPly("", 0)));
    expectIn("is truncated", failureOf(asciiPly("1 2 3 4 3\n1 2", 2)));
    expectIn("is truncated", failureOf(asciiPly("1 2 3 4 3\n", 2000000000)));
    expectIn("'abc' where a number", failureOf(asciiPly("1 2 abc 4 3\n", 1)));
    expectIn("'4.5' where an integer", failureOf(asciiPly("1 2 3 4.5 3\n", 1)));
    expectIn("'nan' where an integer", failureOf(asciiPly("1 2 3 4 nan\n", 1)));
    expectIn("vertex 0", failureOf(asciiPly("1 nan 3 4 3\n", 1)));
    expectIn("category 5", failureOf(asciiPly("1 2 3 4 5\n", 1)));
    expectIn("index,name", failureOf(asciiPly("1 2 3 4 3\n", 1), "id,name\n3,chair\n"));
    expectIn("not a category number", failureOf(asciiPly("1 2 3 4 3\n", 1), "index,name\nx,y\n"));
    expectIn("twice", failureOf(asciiPly("1 2 3 4 3\n", 1), "index,name\n3,a\n3,b\n"));
}

TEST(PlyGroundTruth, noticesATruncatedBinaryFileAtEveryByte)
{
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 2\n" + PROPERTIES + "end_header\n";
    std::string vertices;
    for (int i = 0; i < 2; ++i)
        vertices += raw(1.F) + raw(2.F) + raw(3.F) + raw(uint32_t{4}) + raw(int32_t{3});
    EXPECT_EQ(read(header + vertices).points.size(), 2U);
    for (size_t n = 0; n < vertices.size(); ++n)
        expectIn("is truncated", failureOf(header + vertices.substr(0, n)));
}
