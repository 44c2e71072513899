// SPDX-License-Identifier: BSD-3-Clause
#include "UsersConfigurations.h"

#include <map>
#include <mutex>

namespace voxeland
{
namespace
{
struct Known
{
    std::mutex mutex;
    std::map<std::string, MapperConfig> byText;
};

/** Never destroyed: plugins must not outlive what they are made of. */
Known& known()
{
    static Known* const all = new Known;
    return *all;
}
}  // namespace

void UsersConfigurations::add(const MapperConfig& config)
{
    const std::lock_guard<std::mutex> lock(known().mutex);
    known().byText.insert_or_assign(config.reproducibleText(), config);
}

std::optional<MapperConfig> UsersConfigurations::find(const std::string& text)
{
    const std::lock_guard<std::mutex> lock(known().mutex);
    const auto found = known().byText.find(text);
    return found == known().byText.end() ? std::nullopt : std::optional(found->second);
}
}  // namespace voxeland
