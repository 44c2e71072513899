// SPDX-License-Identifier: BSD-3-Clause
/** The INI with all defaults that is shipped is the one the program prints. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(DefaultConfig, isUpToDate)
{
    const auto dumped = test::runProgram("rawlog2voxeland", {"--dump-config", "all"});
    ASSERT_EQ(dumped.exitCode, 0) << dumped.errors;
    EXPECT_EQ(test::readFile(VOXELAND_DEFAULT_CONFIG), dumped.output)
        << "renew it: build/bin/rawlog2voxeland --dump-config all > share/config/default.ini";
}

TEST(DefaultConfig, readsBackAsItIs)
{
    const auto dumped = test::runProgram("rawlog2voxeland",
                                         {"-c", VOXELAND_DEFAULT_CONFIG, "--dump-config", "all"});
    ASSERT_EQ(dumped.exitCode, 0) << dumped.errors;
    EXPECT_EQ(test::readFile(VOXELAND_DEFAULT_CONFIG), dumped.output);
}
