// SPDX-License-Identifier: BSD-3-Clause
#include "base/Reading.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/math/TPose3D.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>

using namespace voxeland;
using mrpt::serialization::archiveFrom;

namespace
{
/** What an archive holds after some values were put into it. */
template <typename... Values>
mrpt::io::CMemoryStream holding(const Values&... values)
{
    mrpt::io::CMemoryStream stream;
    auto archive = archiveFrom(stream);
    (archive << ... << values);
    stream.Seek(0);
    return stream;
}
}  // namespace

TEST(Reading, readsWhatMrptWrites)
{
    const std::vector<uint32_t> numbers(200000, 7);
    const std::string text(100000, 'x');
    auto stream = holding(numbers, text, true, std::string(), false);
    auto in = archiveFrom(stream);
    EXPECT_EQ(readValues<std::vector<uint32_t>>(in, numbers.size()), numbers);
    EXPECT_EQ(readText(in), text);
    EXPECT_TRUE(readTruth(in));
    EXPECT_EQ(readText(in), "");
    EXPECT_FALSE(readTruth(in));
}

TEST(Reading, anyByteIsATruth)
{
    auto stream = holding(uint8_t{2}, uint8_t{0});
    auto in = archiveFrom(stream);
    EXPECT_EQ(static_cast<int>(readTruth(in)), 1);
    EXPECT_FALSE(readTruth(in));
}

TEST(Reading, sizesAreNotBelieved)
{
    const uint32_t huge = 0xFFFFFFF0U;  // times 4 it is 17 GB
    auto stream = holding(huge, uint32_t{1});
    auto in = archiveFrom(stream);
    EXPECT_ANY_THROW((void)readValues<std::vector<uint32_t>>(in, huge)) << "it ends before";
    stream.Seek(0);
    EXPECT_ANY_THROW((void)readText(in)) << "it is too long";
    auto three = holding(std::vector<uint32_t>{1, 2, 3});
    auto from = archiveFrom(three);
    EXPECT_THROW((void)readValues<std::vector<uint32_t>>(from, 2), std::runtime_error);
}

TEST(Reading, anObjectOfAnotherClassIsNone)
{
    auto stream = holding(mrpt::obs::CObservationComment());
    auto in = archiveFrom(stream);
    EXPECT_THROW((void)readObject<mrpt::obs::CObservationOdometry>(in), std::runtime_error);
}
