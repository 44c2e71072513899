// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/3rdparty/tclap/CmdLine.h>

namespace voxeland::apps
{
/** `--trust-paths`: the user vouches for what the input names outside of its folder. */
class TrustPathsArgument : public TCLAP::SwitchArg
{
 public:
    explicit TrustPathsArgument(TCLAP::CmdLineInterface& parser)
        : SwitchArg("", "trust-paths",
                    "Also read images that the input names outside of its folder, wherever", parser)
    {
    }
};
}  // namespace voxeland::apps
