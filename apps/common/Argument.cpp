// SPDX-License-Identifier: BSD-3-Clause
#include "common/Argument.h"

#include "common/CommandLine.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace voxeland::apps
{
namespace
{
/** The numbers that an option takes, in words. \param given what it was given */
template <typename N>
std::string wanted(const std::string& given)
{
    if (!std::is_integral_v<N>) return "a number";
    std::string kind = "a whole number";
    if (std::is_unsigned_v<N>) kind += " from 0";
    constexpr N MOST = std::numeric_limits<N>::max();
    if (parsed<double>(given) >= static_cast<double>(MOST))
        kind += " up to " + std::to_string(MOST);
    return kind;
}
}  // namespace

Argument::Argument(const std::string& names) : m_name(names.substr(names.rfind(',') + 1)) {}

Switch::Switch(CommandLine& line, const std::string& names, const std::string& description)
    : Argument(names)
{
    line.addSwitch(*this, names, description);
}

SwitchOrText::SwitchOrText(CommandLine& line, const std::string& names, const std::string& value,
                           const std::string& description)
    : Argument(names)
{
    line.addSwitchOrOption(*this, names, value, description);
}

Text::Text(CommandLine& line, const std::string& names, const std::string& value,
           const std::string& description, std::string preset, Presence presence)
    : Argument(names), m_value(std::move(preset))
{
    line.addOption(*this, names, value, description, presence, Occurrence::once);
}

Text::Text(CommandLine& line, const std::string& names, const std::string& value,
           const std::string& description, Presence presence)
    : Text(line, names, value, description, "", presence)
{
}

Texts::Texts(CommandLine& line, const std::string& names, const std::string& value,
             const std::string& description, Presence presence)
    : Argument(names)
{
    line.addOption(*this, names, value, description, presence, Occurrence::repeated);
}

template <typename N>
N numberOf(const std::string& name, const std::string& text)
{
    const auto number = parsed<N>(trimmed(text));
    if (!number || !std::isfinite(static_cast<double>(*number)))
        throw ConfigurationError(name + " takes " + wanted<N>(trimmed(text)) + ", not '" + text +
                                 "' (see --help)");
    return *number;
}

template <typename N>
Number<N>::Number(CommandLine& line, const std::string& names, const std::string& value,
                  const std::string& description, N preset)
    : Argument(names), m_value(preset)
{
    line.addOption(*this, names, value, description, Presence::optional, Occurrence::once);
}

template class Number<double>;
template class Number<int>;
template class Number<int64_t>;
template class Number<uint32_t>;
template class Number<uint64_t>;
}  // namespace voxeland::apps
