// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/version.h>

#include <memory>
#include <type_traits>

/** \file
 * Everything that differs between the MRPT versions supported (2.5.8 and newer 2.x). */

// MRPT 2.14 added the namespace to the macro that declares an abstract class.
#if MRPT_VERSION >= 0x020e00
#define VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CLASS) DEFINE_VIRTUAL_MRPT_OBJECT(CLASS, voxeland)
#else
#define VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CLASS) DEFINE_VIRTUAL_MRPT_OBJECT(CLASS)
#endif

namespace mrpt::maps
{
class CMetricMap;
}

namespace voxeland
{
// MRPT 2.13 made map factories return a smart pointer.
#if MRPT_VERSION >= 0x020d00
using MapFactoryResult = std::shared_ptr<mrpt::maps::CMetricMap>;
#else
using MapFactoryResult = mrpt::maps::CMetricMap*;
#endif

/** What a map factory returns of the map it has made. */
template <typename Map>
MapFactoryResult mapFactoryResult(std::unique_ptr<Map> map)
{
    if constexpr (std::is_pointer_v<MapFactoryResult>)
        return map.release();
    else
        return map;
}
}  // namespace voxeland
