// SPDX-License-Identifier: BSD-3-Clause
/** Map files: what can be read can be asked, written and read again. */
#include "Reading.h"
#include "voxeland/map/MapQueries.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("in.voxeland"), again("again.voxeland");
    return fuzz::readOrRefuse([&] {
        const auto map = loadMap(file.compressing(data, size));
        summarizeInstances(map->map());
        saveMap(*map, again.path());
        try {
            loadMap(again.path());
        } catch (const InputError&) {
            std::abort();  // a map that was written must be readable
        }
    });
}
