// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/PoseAxes.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/lowerCase.h"

#include <algorithm>

namespace voxeland
{
const std::vector<std::pair<std::string, PoseAxes>>& poseAxesByName()
{
    static const std::vector<std::pair<std::string, PoseAxes>> names = {
        {"body", PoseAxes::body}, {"optical", PoseAxes::optical}, {"opengl", PoseAxes::opengl}};
    return names;
}

const std::string& nameOf(PoseAxes axes)
{
    const auto& names = poseAxesByName();
    return std::find_if(names.begin(), names.end(),
                        [axes](const auto& named) { return named.second == axes; })
        ->first;
}

PoseAxes poseAxesNamed(const std::string& name, const std::string& option)
{
    for (const auto& [known, axes] : poseAxesByName())
        if (known == lowerCase(name)) return axes;
    throw ConfigurationError(option + " must be optical, opengl or body, not '" + name + "'");
}

mrpt::poses::CPose3D poseOfAxes(PoseAxes axes)
{
    using namespace mrpt::literals;
    switch (axes) {
        case PoseAxes::optical:
            return {0, 0, 0, -90.0_deg, 0.0_deg, -90.0_deg};
        case PoseAxes::opengl:
            return {0, 0, 0, -90.0_deg, 0.0_deg, 90.0_deg};
        case PoseAxes::body:
            break;
    }
    return {};
}
}  // namespace voxeland
