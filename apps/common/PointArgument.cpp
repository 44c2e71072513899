// SPDX-License-Identifier: BSD-3-Clause
#include "common/PointArgument.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"

#include <cmath>
#include <sstream>

namespace voxeland::apps
{
std::vector<double> numbersIn(const std::string& text, size_t count)
{
    std::vector<double> numbers;
    std::istringstream in(text + ",");
    for (std::string word; std::getline(in, word, ',');) {
        const auto number = parsed<double>(trimmed(word));
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
    }
    return numbers.size() == count ? numbers : std::vector<double>();
}

mrpt::math::TPoint3D parsePoint(const Text& option)
{
    const auto numbers = numbersIn(option.value(), 3);
    if (numbers.empty())
        throw ConfigurationError(option.name() + " '" + option.value() +
                                 "' is not three numbers like 1.5,-2,0.3");
    return {numbers[0], numbers[1], numbers[2]};
}

mrpt::math::TVector3D parseDirection(const Text& option)
{
    const mrpt::math::TVector3D direction = parsePoint(option);
    if (!(direction.norm() > 0)) throw ConfigurationError(option.name() + " must not be 0,0,0");
    return direction;
}

HeightRange parseHeights(const Text& option)
{
    const auto numbers = numbersIn(option.value(), 2);
    if (numbers.empty() || numbers[0] > numbers[1])
        throw ConfigurationError(option.name() + " '" + option.value() +
                                 "' is not two increasing numbers like 0.1,1.8");
    return {numbers[0], numbers[1]};
}
}  // namespace voxeland::apps
