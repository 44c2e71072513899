// SPDX-License-Identifier: BSD-3-Clause
#include "timeText.h"

#include <mrpt/system/datetime.h>

#include <mutex>

namespace voxeland
{
std::string timeText(const mrpt::Clock::time_point& time)
{
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    return mrpt::system::dateTimeToString(time);
}
}  // namespace voxeland
