// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/UnfinishedPredictions.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
class UnfinishedPredictionsTest : public testing::Test
{
 protected:
    /** Asks for the frames [0, frames), of which every third has nothing to look at, and gives the
     *  numbers of those that the network was asked about. */
    std::vector<size_t> askedUpTo(size_t frames, const std::string& origin = "net")
    {
        std::vector<size_t> asked;
        const PredictionSource network = [&](size_t frame, const auto&) {
            asked.push_back(frame);
            if (frame % 3 == 2) return CObservationInstances::Ptr();
            auto seen = CObservationInstances::Create();
            seen->sensorLabel = "frame " + std::to_string(frame);
            return seen;
        };
        UnfinishedPredictions kept(m_file, origin);
        for (size_t i = 0; i < frames; ++i) {
            const auto found = kept.of(i, m_scan, network);
            EXPECT_EQ(found == nullptr, i % 3 == 2) << i;
            if (!found) continue;
            EXPECT_EQ(found->sensorLabel, "frame " + std::to_string(i));
        }
        return asked;
    }

    test::TemporaryFolder m_folder;
    std::string m_file = m_folder.file("k.unfinished");
    mrpt::obs::CObservation3DRangeScan m_scan;
};
using Frames = std::vector<size_t>;
}  // namespace

TEST_F(UnfinishedPredictionsTest, GoesOnWhereItWasStopped)
{
    EXPECT_EQ(askedUpTo(4), (Frames{0, 1, 2, 3}));
    EXPECT_EQ(askedUpTo(7), (Frames{4, 5, 6}));
    EXPECT_EQ(askedUpTo(7), Frames());
    UnfinishedPredictions kept(m_file, "net");
    EXPECT_EQ(kept.frames(), 7U);
    kept.discard();
    EXPECT_FALSE(fs::exists(m_file));
}

TEST_F(UnfinishedPredictionsTest, WhatWasCutOffIsAskedAgain)
{
    askedUpTo(4);
    const auto whole = fs::file_size(m_file);
    for (const auto missing : {1, 3, 20}) {
        fs::resize_file(m_file, whole - static_cast<uintmax_t>(missing));
        EXPECT_EQ(askedUpTo(4), Frames{3}) << missing;
        EXPECT_EQ(fs::file_size(m_file), whole);
    }
}

TEST_F(UnfinishedPredictionsTest, WhatAnotherNetworkSaidIsNotMixedIn)
{
    askedUpTo(4);
    EXPECT_EQ(askedUpTo(2, "another net"), (Frames{0, 1}));
    EXPECT_EQ(askedUpTo(2), (Frames{0, 1})) << "the first one's were replaced";
    test::writeFile(m_file, "something else");
    EXPECT_EQ(askedUpTo(2), (Frames{0, 1}));
}

TEST_F(UnfinishedPredictionsTest, SaysWhereItCannotBeKept)
{
    try {
        UnfinishedPredictions kept(m_folder.file("missing/k.unfinished"), "net");
        FAIL() << "nothing was thrown";
    } catch (const OutputError& e) {
        EXPECT_NE(std::string(e.what()).find("missing/k.unfinished"), std::string::npos);
    }
}

TEST_F(UnfinishedPredictionsTest, WhatALinkLeadsToIsLeftAlone)
{
    test::writeFile(m_folder.file("mine.txt"), "mine");
    fs::create_symlink(m_folder.file("mine.txt"), m_file);
    EXPECT_THROW(askedUpTo(1), OutputError);
    EXPECT_EQ(test::readFile(m_folder.file("mine.txt")), "mine");
}

TEST_F(UnfinishedPredictionsTest, TwoRunsOfOneOutputDoNotMix)
{
    UnfinishedPredictions first(m_file, "net");
    EXPECT_THROW(UnfinishedPredictions(m_file, "net"), OutputError);
}

TEST_F(UnfinishedPredictionsTest, WhatWasDamagedIsAskedAgain)
{
    askedUpTo(4);
    std::string bytes = test::readFile(m_file);
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    test::writeFile(m_file, bytes);
    EXPECT_EQ(askedUpTo(4), Frames{3});
}
