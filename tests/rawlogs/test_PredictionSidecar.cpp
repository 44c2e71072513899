// SPDX-License-Identifier: BSD-3-Clause
/** Each scan gets its predictions out of the file beside the rawlog. */
#include "files/GzOutputFile.h"
#include "rawlogs/RawlogFiles.h"
#include "support/Frames.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/rawlogs/PredictionSidecar.h"

#include <gtest/gtest.h>
#include <mrpt/system/datetime.h>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** Predictions or a scan: when, and the number that tells them from others. */
struct Numbered
{
    double seconds;
    int number;

    bool operator==(const Numbered& other) const
    {
        return seconds == other.seconds && number == other.number;
    }
};

std::string numbered(int number)
{
    return "detector " + std::to_string(number);
}

class ASidecar : public testing::Test
{
 protected:
    void write(const std::vector<Numbered>& all) const
    {
        GzOutputFile out(m_files.sidecar.string());
        for (const Numbered& n : all) {
            const auto predictions = makePredictions({}, n.seconds);
            predictions->sensorLabel = numbered(n.number);
            out.writeObject(*predictions);
        }
        out.close();
    }

    /** Expects that each scan gets predictions of its number; NONE: none.
     *  \param leftOver numbers of the first scans behind those left over */
    void expectPaired(const std::vector<Numbered>& scans,
                      const std::vector<uint32_t>& leftOver = {}) const
    {
        std::vector<uint32_t> left;
        PredictionSidecar sidecar(
            m_files, [](const auto&) { return true; }, [&](uint32_t f) { left.push_back(f); });
        for (uint32_t i = 0; i < scans.size(); ++i) {
            const auto found = sidecar.of(mrpt::Clock::fromDouble(scans[i].seconds), i);
            ASSERT_EQ(found != nullptr, scans[i].number != NONE) << "scan " << i;
            if (found) {
                EXPECT_EQ(found->sensorLabel, numbered(scans[i].number)) << "scan " << i;
            }
        }
        sidecar.finish(static_cast<uint32_t>(scans.size()), true);
        EXPECT_EQ(left, leftOver);
    }

    static constexpr int NONE = -1;
    TemporaryFolder m_folder;
    RawlogFiles m_files{m_folder.file("in.rawlog")};
};
}  // namespace

TEST_F(ASidecar, NeedNotBeThere)
{
    expectPaired({{1, NONE}, {2, NONE}});
}

TEST_F(ASidecar, MayHaveGapsAndMoreThanThereAreScans)
{
    write({{1, 1}, {2, 2}, {3, 3}, {5, 5}, {9, 9}});
    expectPaired({{2, 2}, {3, 3}, {4, NONE}, {5, 5}}, {0, 4});
}

TEST_F(ASidecar, MayGoBackInTimeWhereTheScansDo)
{
    const std::vector<Numbered> all = {{10.0, 0}, {10.1, 1}, {10.2, 2}, {10.3, 3},
                                       {9.5, 4},  {9.6, 5},  {9.7, 6},  {9.8, 7}};
    write(all);
    expectPaired(all);
}

TEST_F(ASidecar, OfEqualTimesTheFirstIsTheFirstScans)
{
    write({{1, 1}, {1, 2}, {2, 3}, {2, 4}});
    expectPaired({{1, 1}, {1, 2}, {2, 3}, {2, 4}});
}

/** Both recordings are of the same times, and the first one's last scans have no predictions. */
TEST_F(ASidecar, RecordingsOfTheSameTimesAreNotMixed)
{
    write({{1, 1}, {2, 2}, {3, 3}, {1, 4}, {2, 5}, {3, 6}, {4, 7}, {5, 8}});
    expectPaired(
        {{1, 1}, {2, 2}, {3, 3}, {4, NONE}, {5, NONE}, {1, 4}, {2, 5}, {3, 6}, {4, 7}, {5, 8}});
}

TEST_F(ASidecar, WhatIsLeftOfARecordingIsNotTheNextOnes)
{
    write({{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {1, 6}, {2, 7}, {5, 8}});
    expectPaired({{1, 1}, {2, 2}, {3, 3}, {1, 6}, {2, 7}, {5, 8}}, {3, 3});
}

TEST_F(ASidecar, MayBeALittleOutOfOrder)
{
    write({{2, 2}, {1, 1}, {3, 3}, {5, 5}, {4, 4}, {6, 6}});
    expectPaired({{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}});
}

TEST_F(ASidecar, OneOutOfPlaceDoesNotKeepTheOthersBack)
{
    write({{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {2, 99}, {6, 6}, {7, 7}});
    expectPaired({{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}}, {5});
}

TEST_F(ASidecar, WithoutTimesTheOrderDecides)
{
    const double none = mrpt::Clock::toDouble(INVALID_TIMESTAMP);
    write({{none, 1}, {none, 2}});
    expectPaired({{none, 1}, {none, 2}});
}

TEST_F(ASidecar, ThatIsCutOffIsTold)
{
    write({{1, 1}, {2, 2}, {3, 3}, {4, 4}});
    const std::string whole = readFile(m_files.sidecar.string());
    writeFile(m_files.sidecar.string(), whole.substr(0, whole.size() / 2));
    PredictionSidecar sidecar(
        m_files, [](const auto&) { return true; }, [](uint32_t) {});
    EXPECT_THROW(sidecar.finish(9, true), InputError);
}
