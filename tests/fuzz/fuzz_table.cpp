// SPDX-License-Identifier: BSD-3-Clause
/** Tables: categories, labels, times. */
#include "Reading.h"
#include "pipeline/TimingLog.h"
#include "voxeland/datasets/CategoryNames.h"
#include "voxeland/datasets/LabelMap.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile csv("table.csv"), json("table.json"), yaml("data.yaml");
    for (const auto* file : {&csv, &json, &yaml})
        fuzz::readOrRefuse([&] { readCategoryNames(file->holding(data, size)); });
    fuzz::readOrRefuse([&] { LabelMap::fromFile(csv.path()); });
    return fuzz::readOrRefuse([&] { TimingLog::fromCsv(csv.path()); });
}
