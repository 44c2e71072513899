// SPDX-License-Identifier: BSD-3-Clause
/** ScanNet's .sens files. */
#include "Reading.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("scene.sens");
    return fuzz::readOrRefuse([&] {
        const auto reader = openDataset("scannet", file.holding(data, size));
        for (RgbdRecord record; reader->next(record);) continue;
    });
}
