// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "common/Argument.h"
#include "voxeland/plugins/Ini.h"

#include <string>

namespace voxeland::apps
{
/** `--set section.key=value`, any number of times: what overrules an INI. */
class SetArgument : public Texts
{
 public:
    /** \param ofWhat whose keys, for --help */
    SetArgument(CommandLine& line, const std::string& ofWhat)
        : Texts(line, "--set", "section.key=value",
                "Set a key of the " + ofWhat + "; may be repeated")
    {
    }

    /** Sets the keys given, in their order. \throws ConfigurationError as Ini::set() */
    void applyTo(Ini& ini) const
    {
        for (const std::string& assignment : values()) ini.set(assignment, name());
    }
};
}  // namespace voxeland::apps
