// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/mrpt_compat.h"
#include "voxeland/plugins/OptionList.h"
#include "voxeland/plugins/PluginAbi.h"

#include <mrpt/rtti/CObject.h>

#include <string>

namespace voxeland
{
inline namespace VOXELAND_PLUGIN_ABI
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
}  // namespace VOXELAND_PLUGIN_ABI
}  // namespace voxeland
