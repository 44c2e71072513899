// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/Ini.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <string>

namespace voxeland::apps
{
/** `--set section.key=value`, any number of times: what overrules an INI. */
class SetArgument : public TCLAP::MultiArg<std::string>
{
 public:
    /** \param ofWhat whose keys, for --help */
    SetArgument(const std::string& ofWhat, TCLAP::CmdLineInterface& parser)
        : MultiArg("", "set", "Set a key of the " + ofWhat + "; may be repeated", false,
                   "section.key=value", parser)
    {
    }

    /** Sets the keys given, in their order. \throws ConfigurationError as Ini::set() */
    void applyTo(Ini& ini)
    {
        for (const std::string& assignment : getValue()) ini.set(assignment, "--set");
    }
};
}  // namespace voxeland::apps
