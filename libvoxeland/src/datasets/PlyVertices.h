// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPoint3D.h>

#include <string>
#include <vector>

namespace voxeland
{
/** What numbers a property of a PLY file may hold. */
enum class PlyNumber
{
    any,
    integer
};

/** A vertex property to read. */
struct PlyColumn
{
    std::string name;
    PlyNumber number = PlyNumber::any;
};

/** Reads properties of the `vertex` element of a PLY file (ascii or binary little endian); others
 *  are skipped, lists included.
 *  \return the values of each property asked for, in that order; all of the same length
 *  \throws InputError, naming the file, if it cannot be read, is malformed or truncated, or lacks a
 *  property */
std::vector<std::vector<double>> readPlyVertices(const std::string& file,
                                                 const std::vector<PlyColumn>& columns);

/** Points from what readPlyVertices() gave, its first three columns being x, y and z.
 *  \throws InputError, naming the file, if there is none, or one is not finite */
std::vector<mrpt::math::TPoint3D> pointsOf(const std::vector<std::vector<double>>& columns,
                                           const std::string& file);
}  // namespace voxeland
