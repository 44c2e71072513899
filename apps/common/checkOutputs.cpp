// SPDX-License-Identifier: BSD-3-Clause
#include "common/checkOutputs.h"

#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <filesystem>
#include <set>

namespace fs = std::filesystem;

namespace voxeland::apps
{
void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs)
{
    const auto place = [](const std::string& file) {
        return fs::weakly_canonical(fs::absolute(file));
    };
    std::set<fs::path> taken;
    for (const std::string& input : inputs)
        if (!input.empty()) taken.insert(place(input));
    for (const std::string& output : outputs)
        if (!output.empty() && !fs::is_character_file(output) &&
            !taken.insert(place(output)).second)
            throw ConfigurationError(
                "output '" + output +
                "' would replace an input or another output: name another file");
    for (const std::string& output : outputs)
        if (!output.empty()) checkWritable(output);
}
}  // namespace voxeland::apps
