// SPDX-License-Identifier: BSD-3-Clause
/** Predictions in COCO's format. */
#include "Reading.h"
#include "datasets/MatchedPredictions.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("coco.json");
    return fuzz::readOrRefuse([&] {
        const CocoPredictions predictions(file.holding(data, size));
        MatchedPredictions matched(predictions, {{0, "0.png"}, {1, "1.png"}});
        for (const size_t frame : {0, 1}) static_cast<void>(matched.instancesFor(frame, 64, 48));
        static_cast<void>(matched.notes());
        static_cast<void>(matched.warnings());
    });
}
