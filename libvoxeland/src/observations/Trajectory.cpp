// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/Trajectory.h"

#include "voxeland/counted.h"
#include "voxeland/numbers.h"
#include "voxeland/observations/TimedLines.h"

#include <mrpt/math/CQuaternion.h>
#include <mrpt/poses/CPose3D.h>

#include <array>
#include <cmath>
#include <optional>

namespace voxeland
{
namespace
{
constexpr const char* FORM = "timestamp tx ty tz qx qy qz qw";
constexpr size_t NUMBERS = 7;  // behind the time

/** The pose that the first seven words give; nothing if they are not finite numbers or the
 *  quaternion is not of unit length. */
std::optional<mrpt::math::TPose3D> poseOf(const std::vector<std::string>& words)
{
    std::array<double, NUMBERS> v{};
    for (size_t i = 0; i < NUMBERS; ++i) {
        const auto number = i < words.size() ? parsed<double>(words[i]) : std::nullopt;
        if (!number || !std::isfinite(*number)) return std::nullopt;
        v[i] = *number;
    }
    const double norm = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
    if (!(std::abs(norm - 1) < 1e-2)) return std::nullopt;
    const mrpt::math::CQuaternionDouble q(v[6] / norm, v[3] / norm, v[4] / norm, v[5] / norm);
    return mrpt::poses::CPose3D(q, v[0], v[1], v[2]).asTPose();
}
}  // namespace

Trajectory Trajectory::fromTumFile(const std::string& file, double maxGap, bool strict)
{
    auto text = TimedLines::fromFile(file, "the trajectory '" + file + "'", FORM, strict);
    Trajectory result{PoseTrack(maxGap), std::move(text.leftOut), std::move(text.notes)};
    for (const TimedLine& line : text.lines) {
        const auto words = separatedWords(line.rest);
        // Values between commas are some other program's, in an order of its own.
        const bool foreign = words.size() > NUMBERS && line.rest.find(',') != std::string::npos;
        const auto pose = foreign ? std::nullopt : poseOf(words);
        if (pose)
            result.poses.add(mrpt::Clock::fromDouble(line.time), *pose);
        else
            result.leftOut.add(text.where(line) + " is not '" + FORM +
                               "' with finite numbers and a unit quaternion");
    }
    const bool isOdd = result.leftOut.count() > 0;
    if (result.poses.empty())
        throw InputError(isOdd ? result.leftOut.first() : text.name + " holds no pose");
    if (isOdd)
        result.notes.push_back(
            result.leftOut.told("line of " + text.name, "lines of " + text.name));
    return result;
}
}  // namespace voxeland
