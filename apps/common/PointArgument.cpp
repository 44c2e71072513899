// SPDX-License-Identifier: BSD-3-Clause
#include "common/PointArgument.h"

#include "voxeland/errors.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace voxeland::apps
{
mrpt::math::TPoint3D parsePoint(const std::string& option, const std::string& text)
{
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    mrpt::math::TPoint3D p;
    char first = 0, second = 0;
    in >> p.x >> first >> p.y >> second >> p.z;
    const bool good = !in.fail() && first == ',' && second == ',' && (in >> std::ws).eof() &&
                      std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    if (!good)
        throw ConfigurationError("--" + option + " '" + text +
                                 "' is not three numbers like 1.5,-2,0.3");
    return p;
}
}  // namespace voxeland::apps
