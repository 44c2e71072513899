// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>

namespace voxeland
{
/** How a category's name fits what a person wrote, from worst to best. Case is ignored; - and _ are
 *  blanks, and several blanks are one. */
enum class NameFit
{
    none,
    part,    //!< the category's name contains it: "table", "tables" and "dining table"
    plural,  //!< one is the plural of the other: "chairs", "mice", "potted plants"
    same
};
NameFit nameFit(const std::string& wanted, const std::string& category);

/** Why a map holds no object of a category, in a few words: that none has it, though the map knows
 *  it, or that the map does not know it, and which one may be meant. Begins in small letters. */
std::string whyNoneIsFound(const SemanticVoxelMap& map, const std::string& wanted);
}  // namespace voxeland
