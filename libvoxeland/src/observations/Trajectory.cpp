// SPDX-License-Identifier: BSD-3-Clause
#include "Trajectory.h"

#include "TimedLines.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/numbers.h"
#include "voxeland/observations/RgbdFrame.h"

#include <mrpt/math/CQuaternion.h>
#include <mrpt/poses/CPose3D.h>

#include <array>
#include <cctype>
#include <cmath>
#include <optional>

namespace voxeland
{
namespace
{
constexpr const char* FORM = "timestamp tx ty tz qx qy qz qw";
constexpr size_t NUMBERS = 7;  // behind the time

/** Where x, y, z and qx, qy, qz, qw stand behind the time. */
using Columns = std::array<size_t, NUMBERS>;
constexpr Columns IN_ORDER = {0, 1, 2, 3, 4, 5, 6};

/** A title without its unit and all but letters: `q_RS_w []` is "qrsw". */
std::string lettersOf(const std::string& title)
{
    std::string letters;
    for (const char c : title.substr(0, title.find_first_of("[(")))
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

/** Which of the seven numbers a title is of, as many programs call them: tx, x, px,
 *  position.x, p_RS_R_x; qw, q_w, orientation.w, rot_w. */
std::optional<size_t> numberTitled(const std::string& title)
{
    const std::string name = lettersOf(title);
    if (name.empty()) return std::nullopt;
    const auto begins = [&](const char* with) { return name.rfind(with, 0) == 0; };
    const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
    const bool isTurn = begins("q") || begins("rot") || has("orientation") || has("quat");
    const bool isPlace = name.size() == 1 || begins("p") || begins("t") || has("position");
    const size_t axis = std::string("xyzw").find(name.back());
    if (axis == std::string::npos) return std::nullopt;
    if (isTurn) return 3 + axis;
    return isPlace && axis < 3 ? std::optional(axis) : std::nullopt;
}

/** The columns of a pose by their titles, or in TUM's order where these do not tell all. */
Columns columnsOf(const std::vector<std::string>& titles)
{
    std::array<std::optional<size_t>, NUMBERS> found;
    for (size_t i = 1; i < titles.size(); ++i)
        if (const auto number = numberTitled(titles[i]); number && !found[*number])
            found[*number] = i - 1;
    Columns columns{};
    for (size_t n = 0; n < NUMBERS; ++n) {
        if (!found[n]) return IN_ORDER;
        columns[n] = *found[n];
    }
    return columns;
}

/** The pose in a line's words; nothing if they are not finite numbers, the quaternion is not of
 * unit length, or no map could be there. */
std::optional<mrpt::math::TPose3D> poseOf(const std::vector<std::string>& words,
                                          const Columns& columns)
{
    std::array<double, NUMBERS> v{};
    for (size_t i = 0; i < NUMBERS; ++i) {
        const size_t at = columns[i];
        const auto number = at < words.size() ? parsed<double>(words[at]) : std::nullopt;
        if (!number || !std::isfinite(*number)) return std::nullopt;
        v[i] = *number;
    }
    const double norm = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
    if (!(std::abs(norm - 1) < 1e-2)) return std::nullopt;
    const mrpt::math::CQuaternionDouble q(v[6] / norm, v[3] / norm, v[4] / norm, v[5] / norm);
    const mrpt::poses::CPose3D pose(q, v[0], v[1], v[2]);
    return isValidPose(pose) ? std::optional(pose.asTPose()) : std::nullopt;
}
}  // namespace

Trajectory Trajectory::fromTumFile(const std::string& file, double maxGap, bool strict)
{
    auto text = TimedLines::fromFile(file, "the trajectory '" + file + "'", FORM, strict);
    Trajectory result{PoseTrack(maxGap), std::move(text.leftOut), std::move(text.notes)};
    const Columns columns = columnsOf(text.titles);
    if (columns != IN_ORDER)
        result.notes.push_back("the columns of " + text.name + " are read as their titles say");
    for (const TimedLine& line : text.lines) {
        const auto words = separatedWords(line.rest);
        // More values, between commas and without titles, are some other program's.
        const bool foreign = columns == IN_ORDER && words.size() > NUMBERS &&
                             line.rest.find(',') != std::string::npos;
        const auto pose = foreign ? std::nullopt : poseOf(words, columns);
        if (pose)
            result.poses.add(mrpt::Clock::fromDouble(line.time), *pose);
        else
            result.leftOut.add(text.where(line) + " is not '" + FORM +
                               "' with finite numbers, a place within 1e9 m and a unit quaternion");
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
