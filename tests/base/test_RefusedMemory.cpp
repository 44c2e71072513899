// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/LeftOut.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/observations/UnusableFrame.h"

#include <gtest/gtest.h>
#include <mrpt/math/CMatrixF.h>
#include <opencv2/core.hpp>

#include <cerrno>
#include <cstddef>
#include <limits>
#include <new>

using namespace voxeland;

namespace
{
/** Notes refusals, and leaves the process as it was. */
class RefusedMemoryTest : public testing::Test
{
 protected:
    void SetUp() override { RefusedMemory::watch(); }
    void TearDown() override
    {
        RefusedMemory::forget();
        std::set_new_handler(nullptr);
        cv::redirectError(nullptr);
    }
};

constexpr size_t TOO_MUCH = std::numeric_limits<std::ptrdiff_t>::max();
constexpr size_t MANY_ROWS = size_t{1} << 30;
}  // namespace

TEST_F(RefusedMemoryTest, IsNotedWhoeverAsksForIt)
{
    EXPECT_NO_THROW(RefusedMemory::check());
    EXPECT_THROW(static_cast<void>(::operator new(TOO_MUCH)), std::bad_alloc);
    EXPECT_THROW(RefusedMemory::check(), std::bad_alloc);
    RefusedMemory::forget();
    EXPECT_THROW(cv::fastMalloc(TOO_MUCH), cv::Exception);
    EXPECT_TRUE(RefusedMemory::isNoted());
    RefusedMemory::forget();
    EXPECT_THROW(mrpt::math::CMatrixF(MANY_ROWS, MANY_ROWS), std::bad_alloc);
    EXPECT_TRUE(RefusedMemory::isNoted());
}

TEST_F(RefusedMemoryTest, IsNotTakenForDamagedData)
{
    LeftOut leftOut;
    leftOut.add("odd");
    EXPECT_STREQ(UnusableFrame("odd").what(), "odd");
    RefusedMemory::note();
    EXPECT_THROW(leftOut.add("odd"), std::bad_alloc);
    EXPECT_THROW(UnusableFrame("odd"), std::bad_alloc);
    EXPECT_EQ(leftOut.count(), 1U);
}

TEST_F(RefusedMemoryTest, IsOneErrorOfCLibraries)
{
    errno = ENOENT;
    RefusedMemory::noteErrno();
    EXPECT_FALSE(RefusedMemory::isNoted());
    errno = ENOMEM;
    RefusedMemory::noteErrno();
    EXPECT_TRUE(RefusedMemory::isNoted());
}
