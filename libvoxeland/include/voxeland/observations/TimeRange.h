// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/numbers.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

namespace voxeland
{
/** Time from one to a later one, however far they are apart [s]. */
inline double secondsBetween(const mrpt::Clock::time_point& earlier,
                             const mrpt::Clock::time_point& later)
{
    const auto ticks = [](const mrpt::Clock::time_point& time) {
        return static_cast<uint64_t>(time.time_since_epoch().count());
    };
    return static_cast<double>(ticks(later) - ticks(earlier)) *
           static_cast<double>(mrpt::Clock::period::num) /
           static_cast<double>(mrpt::Clock::period::den);
}

/** The times between a first and a last one [s since 1970, or since what a file counts from]. */
struct TimeRange
{
    double first = std::numeric_limits<double>::infinity();
    double last = -std::numeric_limits<double>::infinity();

    void include(double time)
    {
        first = std::min(first, time);
        last = std::max(last, time);
    }
    [[nodiscard]] bool empty() const { return first > last; }
    [[nodiscard]] bool contains(double time) const { return first <= time && time <= last; }
    [[nodiscard]] bool overlaps(const TimeRange& other) const
    {
        return first <= other.last && other.first <= last;
    }
    /** "1305031100.000 to 1305031101.100 s" */
    [[nodiscard]] std::string text() const
    {
        return fixedText(first, 3) + " to " + fixedText(last, 3) + " s";
    }
};
}  // namespace voxeland
