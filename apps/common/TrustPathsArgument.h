// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "common/Argument.h"

namespace voxeland::apps
{
/** `--trust-paths`: the user vouches for what the input names outside of its folder. */
class TrustPathsArgument : public Switch
{
 public:
    explicit TrustPathsArgument(CommandLine& line)
        : Switch(line, "--trust-paths",
                 "Also read images that the input names outside of its folder, wherever")
    {
    }
};
}  // namespace voxeland::apps
