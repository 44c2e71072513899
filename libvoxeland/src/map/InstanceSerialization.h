// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/Instance.h"

#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <stdexcept>
#include <string>

/** \file What MapSerialization.cpp puts into an archive piece by piece. Reading throws
 * std::runtime_error for what no mapping could have given. */
namespace voxeland
{
void write(mrpt::serialization::CArchive& out, const VoxelCoord& c);
VoxelCoord readBlockCoord(mrpt::serialization::CArchive& in);

/** A positive, finite number. */
template <typename Number>
Number readEvidence(mrpt::serialization::CArchive& in)
{
    const auto evidence = in.ReadAs<Number>();
    if (!(evidence > 0) || !std::isfinite(evidence))
        throw std::runtime_error("corrupt map: evidence of " + std::to_string(evidence));
    return evidence;
}

void write(mrpt::serialization::CArchive& out, const Decision& d);
/** \param categories those of the map */
Decision readDecision(mrpt::serialization::CArchive& in, const CategoryTable& categories);

/** All of an instance but its number of voxels, which follows from those. */
void write(mrpt::serialization::CArchive& out, const Instance& i);
/** \param categories those of the map \param version of what was written, see MapSerialization.cpp
 */
Instance readInstance(mrpt::serialization::CArchive& in, const CategoryTable& categories,
                      uint32_t viewsKept, uint8_t version);
}  // namespace voxeland
