// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/StageTimes.h"

#include <ctime>

namespace voxeland
{
namespace
{
double threadSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
}  // namespace

StageTimer::StageTimer(StageTimes& times, Stage stage)
    : m_time(times[static_cast<size_t>(stage)]), m_start(threadSeconds())
{
}

StageTimer::~StageTimer()
{
    m_time += threadSeconds() - m_start;
}
}  // namespace voxeland
