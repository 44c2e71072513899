// SPDX-License-Identifier: BSD-3-Clause
/** Configurations, of a user's file and of a map. */
#include "Reading.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <cstdlib>
#include <random>

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("my.ini");
    // Another one each time: libFuzzer puts what it sees compared into later input.
    static std::mt19937_64 random;
    const std::string secret = "secret" + std::to_string(random());
    setenv("VOXELAND_SECRET", secret.c_str(), 1);
    const auto expectKept = [&](const std::string& text) {
        if (text.find(secret) != std::string::npos) std::abort();
    };
    fuzz::readOrRefuse([&] {
        const Ini ini = Ini::fromMap({data, data + size}, "m.voxeland");
        expectKept(ini.text());
        const MapperConfig config(ini, MapperConfig::Purpose::mapping, expectKept);
        expectKept(config.text());
    });
    return fuzz::readOrRefuse([&] {
        const std::string text = MapperConfig(Ini::fromFile(file.holding(data, size))).text();
        expectKept(text);
        if (MapperConfig(Ini::fromText(text, "printed")).text() != text) std::abort();
    });
}
