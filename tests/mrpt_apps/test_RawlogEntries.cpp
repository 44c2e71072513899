// SPDX-License-Identifier: BSD-3-Clause
/** What voxeland-run gives MRPT's applications of a rawlog with a sidecar. */
#include "files/GzOutputFile.h"
#include "rawlogs/RawlogFiles.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland-run/RawlogEntries.h"

#include <gtest/gtest.h>

using namespace mrpt::obs;
using namespace voxeland;
using namespace voxeland::test;

TEST(RawlogEntries, PredictionsOfAllDetectorsFollowTheirScan)
{
    const TemporaryFolder folder;
    const std::string rawlog = folder.file("in.rawlog");
    auto frames = smallFrames(2);
    for (auto& frame : frames) frame.pose = nullptr;
    const auto other = std::make_shared<CObservationInstances>(*frames[0].instances);
    frames[0].instances->sensorLabel = "yolo";
    other->sensorLabel = "mask2former";
    frames.insert(frames.begin() + 1, SmallFrame{nullptr, other, nullptr});
    writeRawlog(rawlog, frames);

    apps::RawlogEntries entries(rawlog, false);
    std::vector<std::string> labels;
    std::vector<size_t> numbers;
    while (const auto entry = entries.next()) {
        labels.push_back(entry->observation->sensorLabel);
        numbers.push_back(entries.objectsRead());
    }
    const std::string scan = frames[0].scan->sensorLabel;
    EXPECT_EQ(labels, (std::vector<std::string>{scan, "yolo", "mask2former", scan,
                                                frames.back().instances->sensorLabel}));
    EXPECT_EQ(numbers, (std::vector<size_t>{1, 1, 1, 2, 2})) << "the sidecar does not count";
}

TEST(RawlogEntries, ScansOfASensoryFrameNeedNotBeInOrderOfTime)
{
    const TemporaryFolder folder;
    const std::string rawlog = folder.file("in.rawlog");
    auto frames = smallFrames(3);
    CSensoryFrame both;
    both.insert(frames[1].scan);
    both.insert(frames[0].scan);
    for (auto& frame : frames) frame.scan = nullptr;
    writeRawlog(rawlog, frames);
    GzOutputFile out(rawlog);
    out.writeObject(CActionCollection());
    out.writeObject(both);
    out.close();

    apps::RawlogEntries entries(rawlog, false);
    const auto entry = entries.next();
    ASSERT_TRUE(entry && entry->frame);
    std::vector<mrpt::Clock::time_point> times;
    for (const auto& observation : *entry->frame)
        if (std::dynamic_pointer_cast<CObservationInstances>(observation))
            times.push_back(observation->timestamp);
    EXPECT_EQ(times, (std::vector<mrpt::Clock::time_point>{frames[1].instances->timestamp,
                                                           frames[0].instances->timestamp}))
        << "each after its scan";
    EXPECT_EQ(entries.objectsRead(), 2U);
    EXPECT_FALSE(entries.next());
}
