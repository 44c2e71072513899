// SPDX-License-Identifier: BSD-3-Clause
#include "common/PointArgument.h"

#include "voxeland/errors.h"
#include "voxeland/numbers.h"
#include "voxeland/trimmed.h"

#include <cmath>
#include <sstream>

namespace voxeland::apps
{
namespace
{
/** Reads finite numbers separated by commas, just as many as there are. */
bool readNumbers(const std::string& text, std::initializer_list<double*> numbers)
{
    std::istringstream in(text + ',');
    std::string word;
    for (double* number : numbers) {
        std::getline(in, word, ',');
        const auto value = parsed<double>(trimmed(word));
        if (!value || !std::isfinite(*value)) return false;
        *number = *value;
    }
    return in.peek() == std::istringstream::traits_type::eof();
}
}  // namespace

mrpt::math::TPoint3D parsePoint(const std::string& option, const std::string& text)
{
    mrpt::math::TPoint3D p;
    if (!readNumbers(text, {&p.x, &p.y, &p.z}))
        throw ConfigurationError("--" + option + " '" + text +
                                 "' is not three numbers like 1.5,-2,0.3");
    return p;
}

mrpt::math::TVector3D parseDirection(const std::string& option, const std::string& text)
{
    const mrpt::math::TVector3D direction = parsePoint(option, text);
    if (!(direction.norm() > 0)) throw ConfigurationError("--" + option + " must not be 0,0,0");
    return direction;
}

HeightRange parseHeights(const std::string& option, const std::string& text)
{
    HeightRange range;
    if (!readNumbers(text, {&range.low, &range.high}) || range.low > range.high)
        throw ConfigurationError("--" + option + " '" + text +
                                 "' is not two increasing numbers like 0.1,1.8");
    return range;
}
}  // namespace voxeland::apps
