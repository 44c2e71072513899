// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace voxeland;

TEST(Numbers, ParsesWholeTextsOnly)
{
    EXPECT_EQ(parsed<double>("1.5"), 1.5);
    EXPECT_EQ(parsed<double>("-2e3"), -2000);
    EXPECT_EQ(parsed<double>("+4"), 4);
    EXPECT_TRUE(std::isnan(parsed<double>("nan").value()));
    EXPECT_EQ(parsed<double>("-inf"), -std::numeric_limits<double>::infinity());
    for (const char* text : {"", "1,5", "1.5m", " 1", "1 ", "+-1", "+", "0x10", "1e999"})
        EXPECT_FALSE(parsed<double>(text)) << "'" << text << "'";
}

TEST(Numbers, ParsesIntegersWithinTheirRange)
{
    EXPECT_EQ(parsed<int64_t>("-12"), -12);
    EXPECT_EQ(parsed<uint32_t>("4294967295"), 4294967295u);
    EXPECT_FALSE(parsed<uint32_t>("4294967296"));
    EXPECT_FALSE(parsed<uint32_t>("-1"));
    EXPECT_FALSE(parsed<int64_t>("1.0"));
}

TEST(Numbers, TextIsShortAndReadsBack)
{
    EXPECT_EQ(numberText(0.05), "0.05");
    EXPECT_EQ(numberText(100000), "100000");
    EXPECT_EQ(numberText(1e6), "1e+06");
    EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(numberText(std::nan("")), "nan");
    for (const double value : {1.0 / 3, -4637512.123456, 5e-324, 1.7976931348623157e308})
        EXPECT_EQ(parsed<double>(numberText(value)), value);
}

TEST(Numbers, LengthsAreToTheMicrometre)
{
    EXPECT_EQ(metresText(3 * 0.05), "0.15");
    EXPECT_EQ(metresText(5572093.850000001), "5572093.85");
    EXPECT_EQ(metresText(-1.23456789), "-1.234568");
}

TEST(Numbers, FixedTextHasItsDecimals)
{
    EXPECT_EQ(fixedText(2.5, 2), "2.50");
    EXPECT_EQ(fixedText(-0.126, 2), "-0.13");
    EXPECT_EQ(fixedText(4637512.25, 1), "4637512.2");  // half to even, as printf
    EXPECT_EQ(fixedText(1e300, 0).size(), 301u);
}
