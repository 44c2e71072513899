// SPDX-License-Identifier: BSD-3-Clause
#include "files/GzInputFile.h"
#include "files/GzOutputFile.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>

#include <random>

using namespace voxeland;
using voxeland::test::TemporaryFolder;

namespace
{
mrpt::obs::CObservationComment comment(const std::string& text)
{
    mrpt::obs::CObservationComment c;
    c.text = text;
    return c;
}

/** Text that does not compress. */
std::string noise(size_t bytes)
{
    std::mt19937 random(1);
    std::string text(bytes, ' ');
    for (char& c : text) c = static_cast<char>(random());
    return text;
}

void writeThree(const std::string& file, int compression = 1)
{
    GzOutputFile out(file, compression);
    for (const size_t size : {10U, 30000U, 20U}) out.writeObject(comment(noise(size)));
    out.close();
}

std::vector<std::string> readAll(const std::string& file)
{
    std::vector<std::string> texts;
    GzInputFile in(file);
    while (const auto object = in.readObject())
        texts.push_back(dynamic_cast<mrpt::obs::CObservationComment&>(*object).text);
    return texts;
}
}  // namespace

TEST(GzOutputFile, noticesAFullDevice)
{
    GzOutputFile file("/dev/full");
    file.Write("abc", 3);  // stays in zlib's buffer
    EXPECT_THROW(file.close(), OutputError);
}

TEST(GzOutputFile, noticesAFullDeviceInTheMiddleOfAnObject)
{
    GzOutputFile file("/dev/full");
    try {
        file.writeObject(comment(noise(1000000)));
        FAIL() << "no exception";
    } catch (const OutputError& e) {
        EXPECT_STREQ(e.what(),
                     "cannot write /dev/full: No space left on device: free some space or choose "
                     "another place");
    }
}

TEST(GzInputFile, readsWhatWasWritten)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    EXPECT_EQ(readAll(folder.file("f")),
              (std::vector<std::string>{noise(10), noise(30000), noise(20)}));
}

TEST(GzInputFile, objectBytesMakeTheSameFileAgain)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    {
        GzInputFile in(folder.file("f"));
        in.keepObjectBytes();
        GzOutputFile out(folder.file("copy"));
        while (in.readObject()) out.Write(in.objectBytes().data(), in.objectBytes().size());
        EXPECT_NEAR(in.progress(), 1, 1e-9);
        out.close();
    }
    EXPECT_EQ(readAll(folder.file("copy")), readAll(folder.file("f")));
}

TEST(GzInputFile, noticesAFileThatIsCutAnywhere)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    const std::string whole = test::readFile(folder.file("f"));
    for (const size_t cut : {size_t{1}, size_t{4}, size_t{9}, whole.size() / 2}) {
        test::writeFile(folder.file("cut"), whole.substr(0, whole.size() - cut));
        EXPECT_THROW(readAll(folder.file("cut")), InputError) << cut << " bytes missing";
    }
    test::writeFile(folder.file("cut"), "");
    EXPECT_TRUE(readAll(folder.file("cut")).empty());
}

TEST(GzInputFile, noticesADamagedFileAndOneOfSomethingElse)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    std::string bytes = test::readFile(folder.file("f"));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
    test::writeFile(folder.file("damaged"), bytes);
    EXPECT_THROW(readAll(folder.file("damaged")), InputError);
    test::writeFile(folder.file("text"), "This is no rawlog at all, just a text.");
    EXPECT_THROW(readAll(folder.file("text")), InputError);
    EXPECT_THROW(readAll(folder.file("missing")), InputError);
    EXPECT_THROW(readAll(folder.path().string()), InputError);
}

TEST(GzInputFile, tellsAnObjectOfANewerVersionFromDamage)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"), 0);
    GzInputFile in(folder.file("f"));
    in.keepObjectBytes();
    in.readObject();
    std::string bytes = in.objectBytes();
    bytes[1 + std::string("mrpt::obs::CObservationComment").size()] = 99;
    test::writeFile(folder.file("newer"), bytes);
    try {
        readAll(folder.file("newer"));
        FAIL() << "no exception";
    } catch (const InputError& e) {
        EXPECT_EQ(e.what(), folder.file("newer") +
                                " after 0 bytes: an object of a newer version than is known here; "
                                "was it written with a newer MRPT?");
    }
}

namespace
{
/** A rawlog of one frame with an embedded JPEG picture, uncompressed. */
std::string frameWithPicture()
{
    constexpr int WIDTH = 160, HEIGHT = 120;
    mrpt::obs::CObservation3DRangeScan scan;
    scan.sensorLabel = "behind the picture";
    scan.hasIntensityImage = true;
    scan.intensityImage.resize(WIDTH, HEIGHT, mrpt::img::CH_RGB);
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column)
            scan.intensityImage.setPixel(
                column, row,
                mrpt::img::TColor(static_cast<uint8_t>(column), static_cast<uint8_t>(row), 90));
    const TemporaryFolder folder;
    GzOutputFile out(folder.file("a.rawlog"), 0);
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(false);
    out.writeObject(scan);
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
    out.close();
    GzInputFile in(folder.file("a.rawlog"));
    in.keepObjectBytes();
    EXPECT_TRUE(in.readObject());
    return in.objectBytes();
}
}  // namespace

TEST(GzInputFile, aDamagedPictureEndsNeitherTheProgramNorItsSilence)
{
    const std::string whole = frameWithPicture();
    const size_t picture = whole.find("\xFF\xD8\xFF"), scan = whole.find("\xFF\xDA", picture);
    ASSERT_NE(scan, std::string::npos);
    const size_t end = whole.find("\xFF\xD9", scan);
    const TemporaryFolder folder;
    const std::string file = folder.file("a.rawlog");
    testing::internal::CaptureStderr();
    size_t refused = 0, damaged = 0, empty = 0;
    for (size_t at = picture; at < end; ++at) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
        test::writeFile(file, flipped);
        try {
            GzInputFile in(file);
            const auto scan =
                std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(in.readObject());
            ASSERT_TRUE(scan);
            EXPECT_EQ(scan->sensorLabel, "behind the picture");
            damaged += in.damagedPictures();
            empty += scan->intensityImage.isEmpty() ? 1 : 0;
        } catch (const InputError& e) {
            ++refused;
            EXPECT_NE(std::string(e.what()).find(file), std::string::npos) << e.what();
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(refused, 0U);
    EXPECT_GT(empty, 10U);
    EXPECT_GT(damaged, 10U + empty);
}

namespace
{
/** \param size in the bytes of the scan, to be replaced by one of the same length */
void expectToTakeTooMuch(const mrpt::obs::CObservation3DRangeScan& scan, const std::string& size,
                         const std::string& byLarger)
{
    const TemporaryFolder folder;
    const std::string file = folder.file("a.rawlog");
    {
        GzOutputFile out(file, 0);
        out.writeObject(scan);
        out.close();
    }
    std::string bytes;
    {
        GzInputFile in(file);
        in.keepObjectBytes();
        ASSERT_TRUE(in.readObject());
        bytes = in.objectBytes();
    }
    const size_t at = bytes.find(size);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, size.size(), byLarger);
    test::writeFile(file, bytes);
    GzInputFile in(file);
    try {
        (void)in.readObject();
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("more memory than"), std::string::npos) << e.what();
    }
}
}  // namespace

TEST(GzInputFile, whatASizeInAFileSaysIsNotReserved)
{
    mrpt::obs::CObservation3DRangeScan points;
    points.hasPoints3D = true;
    points.resizePoints3DVectors(0x1234);
    expectToTakeTooMuch(points, {"\x34\x12\0\0", 4}, "\xFF\xFF\xFF\x7F");  // 24 GB
    mrpt::obs::CObservation3DRangeScan ranges;
    ranges.hasRangeImage = true;
    ranges.rangeImage_setSize(3, 0x1234);
    ranges.rangeImage.fill(0);
    expectToTakeTooMuch(ranges, {"\3\0\0\0\x34\x12\0\0", 8},
                        {"\xFF\xFF\xFF\0\x34\x12\0\0", 8});  // 156 GB
}

TEST(GzInputFile, aClassWithoutObjectsIsTakenForDamage)
{
    const TemporaryFolder folder;
    const std::string name = "mrpt::obs::CObservation";  // as MRPT writes the begin of an object
    voxeland::test::writeFile(folder.file("a.rawlog"),
                              static_cast<char>(0x80 | name.size()) + name + std::string(50, '\1'));
    testing::internal::CaptureStderr();
    try {
        GzInputFile(folder.file("a.rawlog")).readObject();
        FAIL() << "no exception";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("of a class that is not known"), std::string::npos)
            << e.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}
