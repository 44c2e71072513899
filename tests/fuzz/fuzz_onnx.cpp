// SPDX-License-Identifier: BSD-3-Clause
/** What networks say of themselves. */
#include "OnnxFile.h"
#include "Reading.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("model.onnx");
    return fuzz::readOrRefuse([&] { OnnxFile{file.holding(data, size)}; });
}
