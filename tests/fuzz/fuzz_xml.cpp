// SPDX-License-Identifier: BSD-3-Clause
/** SceneNN's lists of objects. */
#include "Reading.h"
#include "support/TestFiles.h"
#include "voxeland/datasets/GroundTruth.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("011.xml");
    test::writeFile(file.beside("011.ply"),
                    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                    "property float z\nproperty int label\nend_header\n0 0 0 1\n1 0 0 2\n");
    return fuzz::readOrRefuse([&] {
        file.holding(data, size);
        readSceneNNGroundTruth(file.folder());
    });
}
