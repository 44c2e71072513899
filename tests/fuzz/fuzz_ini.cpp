// SPDX-License-Identifier: BSD-3-Clause
/** Configurations. */
#include "Reading.h"
#include "voxeland/pipeline/MapperConfig.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("my.ini");
    return fuzz::readOrRefuse([&] {
        const std::string text = MapperConfig(Ini::fromFile(file.holding(data, size))).text();
        if (MapperConfig(Ini::fromText(text, "printed")).text() != text) std::abort();
    });
}
