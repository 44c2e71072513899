// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <string>

namespace voxeland::test
{
/** A map as it is stored: equal for equal maps only. */
inline std::string bytesOf(const SemanticVoxelMap& map)
{
    mrpt::io::CMemoryStream stream;
    stream.setAllocBlockSize(1 << 24);  // sanitizers copy what grows by a little each time
    auto archive = mrpt::serialization::archiveFrom(stream);
    map.writeTo(archive);
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}
}  // namespace voxeland::test
