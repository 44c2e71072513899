// SPDX-License-Identifier: BSD-3-Clause
/** Labelled points. */
#include "Reading.h"
#include "support/TestFiles.h"
#include "voxeland/datasets/GroundTruth.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("truth.ply");
    test::writeFile(file.beside("categories.csv"), "index,name\n0,chair\n1,table\n");
    return fuzz::readOrRefuse([&] { readPlyGroundTruth(file.holding(data, size)); });
}
