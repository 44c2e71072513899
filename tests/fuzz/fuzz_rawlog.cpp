// SPDX-License-Identifier: BSD-3-Clause
/** Rawlogs, with predictions inside. */
#include "Reading.h"
#include "voxeland/rawlogs/RawlogFrameSource.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("in.rawlog");
    return fuzz::readOrRefuse([&] {
        RawlogFrameSource source(file.compressing(data, size), {}, {});
        while (source.next()) continue;
        static_cast<void>(source.notes());
    });
}
