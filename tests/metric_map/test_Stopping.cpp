// SPDX-License-Identifier: BSD-3-Clause
/** A mapping run that is stopped and gone on with makes the map of one that was not. */
#include "support/MapBytes.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
/** Maps a range of a rawlog, until the source has met so many frames.
 *  \return first frame left out, if any */
std::optional<uint32_t> mapPart(const std::string& rawlog, const FrameRange& range, int mostMet,
                                CVoxelandMap& map)
{
    RawlogFrameSource source(rawlog, map.mapper().config().input, range);
    source.stopWhen([&mostMet] { return --mostMet < 0; });
    mapRawlog(source, map, [](const StageTimes&) {});
    return source.stoppedBefore();
}
}  // namespace

TEST(Stopping, GoingOnMakesTheSameMap)
{
    const test::TemporaryFolder folder;
    const std::string rawlog = folder.file("in.rawlog");
    test::writeRawlog(rawlog, test::smallFrames(14));
    for (const FrameRange& range : {FrameRange{}, FrameRange{3, 12, 2}}) {
        const MapperConfig config;
        CVoxelandMap whole(config);
        EXPECT_EQ(mapPart(rawlog, range, 100, whole), std::nullopt);
        for (const int met : {0, 1, 2, 4, 7, 12, 13}) {
            CVoxelandMap parts(config);
            const auto stopped = mapPart(rawlog, range, met, parts);
            if (stopped) {
                EXPECT_EQ(mapPart(rawlog, {*stopped, range.to, range.every}, 100, parts),
                          std::nullopt);
            }
            EXPECT_EQ(test::bytesOf(parts.map()), test::bytesOf(whole.map()))
                << met << " frames met";
        }
    }
}
