// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/MapperConfig.h"

#include <optional>
#include <string>

namespace voxeland
{
/** The configurations that maps of this process were given. A map that is read and holds the text
 *  of one of them is a copy of such a map, or was made likewise: the user chose what it says. */
class UsersConfigurations
{
 public:
    static void add(const MapperConfig& config);
    /** \param text as of MapperConfig::reproducibleText() */
    [[nodiscard]] static std::optional<MapperConfig> find(const std::string& text);
};
}  // namespace voxeland
