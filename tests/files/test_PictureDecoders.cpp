// SPDX-License-Identifier: BSD-3-Clause
/** What OpenCV makes of damaged pictures where this library is loaded. */
#include "files/PictureDecoders.h"
#include "voxeland/base/RefusedMemory.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/io/CMemoryStream.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <zlib.h>

using namespace voxeland;

namespace
{
std::vector<uint8_t> encoded(const char* ending)
{
    cv::Mat image(40, 60, CV_8UC3);
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.cols; ++column)
            image.at<cv::Vec3b>(row, column) =
                cv::Vec3b(static_cast<uint8_t>(4 * column), static_cast<uint8_t>(6 * row), 90);
    std::vector<uint8_t> bytes;
    cv::imencode(ending, image, bytes);
    return bytes;
}

/** What is printed on stderr while damaged versions of a picture are decoded. */
std::string printedBy(const std::vector<uint8_t>& whole)
{
    testing::internal::CaptureStderr();
    for (size_t at = 0; at < whole.size(); ++at) {
        auto flipped = whole;
        flipped[at] = static_cast<uint8_t>(flipped[at] ^ 0x10);
        cv::imdecode(flipped, cv::IMREAD_UNCHANGED);
    }
    for (size_t size = 1; size < whole.size(); size += 10)
        cv::imdecode(
            std::vector<uint8_t>(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)),
            cv::IMREAD_UNCHANGED);
    return testing::internal::GetCapturedStderr();
}
}  // namespace

TEST(PictureDecoders, printNothing)
{
    const uint64_t before = damagedPictures();
    EXPECT_EQ(printedBy(encoded(".png")), "");
    EXPECT_EQ(printedBy(encoded(".jpg")), "");
    EXPECT_GT(damagedPictures(), before);
}

TEST(PictureDecoders, APictureThatPromisesMorePixelsThanAnyFrameHasIsDamagedAndNoLackOfMemory)
{
    std::vector<uint8_t> bytes = encoded(".jpg");
    const std::vector<uint8_t> frameHeader = {0xFF, 0xC0};
    const auto header =
        std::search(bytes.begin(), bytes.end(), frameHeader.begin(), frameHeader.end());
    ASSERT_LT(header + 9, bytes.end());
    for (int i = 5; i < 9; ++i) header[i] = 0xFF;  // height and width: 65535

    RefusedMemory::watch();
    const uint64_t before = damagedPictures();
    mrpt::io::CMemoryStream stream(bytes.data(), bytes.size());
    mrpt::img::CImage image;
    image.loadFromStreamAsJPEG(stream);
    EXPECT_TRUE(image.isEmpty());
    EXPECT_EQ(damagedPictures(), before + 1);
    EXPECT_FALSE(RefusedMemory::isNoted());
}

TEST(PictureDecoders, APictureOfMorePixelsThanTheLimitIsNotDecoded)
{
    for (const char* ending : {".png", ".jpg"}) {
        const std::vector<uint8_t> bytes = encoded(ending);  // of 60x40
        const uint64_t before = oversizedPictures();
        const auto decoded = [&] {
            try {
                return !cv::imdecode(bytes, cv::IMREAD_UNCHANGED).empty();
            } catch (const std::exception&) {
                return false;
            }
        };
        {
            const PictureLimit enough(60 * 40), moreDoesNotHelp(1000000);
            EXPECT_TRUE(decoded());
            const PictureLimit limit(60 * 40 - 1);
            EXPECT_FALSE(decoded());
        }
        EXPECT_TRUE(decoded());
        EXPECT_EQ(oversizedPictures(), before + 1) << ending;
    }
}

TEST(PictureDecoders, APngOfAGigapixelIsNotDecoded)
{
    // Rows of zeros: 9e8 pixels of 16 bits, of which the file needs the header alone.
    std::vector<uint8_t> bytes = encoded(".png");
    const std::vector<uint8_t> sides = {0, 0, 0x75, 0x30, 0, 0, 0x75, 0x30};  // 30000 each
    std::copy(sides.begin(), sides.end(), bytes.begin() + 16);
    const uLong check = crc32(0, bytes.data() + 12, 17);
    for (int i = 0; i < 4; ++i) bytes[29 + i] = static_cast<uint8_t>(check >> (24 - 8 * i));
    const uint64_t before = oversizedPictures();
    EXPECT_TRUE(cv::imdecode(bytes, cv::IMREAD_UNCHANGED).empty());
    EXPECT_EQ(oversizedPictures(), before + 1);
}
