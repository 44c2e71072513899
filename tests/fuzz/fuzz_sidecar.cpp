// SPDX-License-Identifier: BSD-3-Clause
/** Predictions beside a rawlog, mapped with it. */
#include "Reading.h"
#include "rawlogs/RawlogFiles.h"
#include "support/SmallRawlog.h"
#include "voxeland/metric_map/RawlogMapping.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("in.instances.rawlog");
    static const std::string rawlog = [] {
        std::string name = file.beside("in.rawlog");
        test::writeRawlog(name, test::smallFrames(2));
        return name;
    }();
    // One thread: the same coverage each time.
    static const MapperConfig config(Ini::fromText("[voxeland]\nthreads = 1\n", "fuzz"));
    return fuzz::readOrRefuse([&] {
        file.compressing(data, size);
        CVoxelandMap map(config);
        RawlogFrameSource source(rawlog, config.input, {});
        mapRawlog(source, map, [](const StageTimes&) {});
    });
}
