// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/mrpt_compat.h"
#include "voxeland/plugins/OptionList.h"

#include <mrpt/rtti/CObject.h>

#include <string>

namespace voxeland
{
/** Changes whenever the plugin bases do: a plugin built for others then fails to load, with a text
 * that says so, instead of crashing. */
inline namespace abi_1
{
/** What all plugin classes have in common. A plugin is configured once and then used through const
 *  functions from several threads. Register concrete classes with
 *  RegisteredClass. */
class Plugin : public mrpt::rtti::CObject
{
    VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(Plugin)

 public:
    /** One line for --list-plugins. */
    [[nodiscard]] virtual std::string description() const = 0;

    /** Lists the INI keys of the class's section, each bound to a member that holds its default. */
    virtual void declareOptions(OptionList& options) = 0;

    /** Called once, after the options were read and checked: the place to load models and files.
     *  \throws ConfigurationError or InputError, naming key and remedy */
    virtual void start() {}
};
}  // namespace abi_1
}  // namespace voxeland
