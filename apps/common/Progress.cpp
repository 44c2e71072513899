// SPDX-License-Identifier: BSD-3-Clause
#include "common/Progress.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace voxeland::apps
{
Progress::Progress(std::string what, size_t total, bool shown)
    : m_what(std::move(what)),
      m_total(total),
      m_shown(shown),
      m_terminal(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
    if (m_drawn && m_terminal) std::cerr << "\n";
}

void Progress::update(size_t done, double fraction)
{
    if (!m_shown) return;
    if (fraction < 0 && m_total > 0)
        fraction = static_cast<double>(done) / static_cast<double>(m_total);
    const auto now = clock::now();
    if (!m_begin) {
        m_begin = Begin{now, done, fraction};
        m_lastDrawn = now;
    }
    const double pause = m_terminal ? 0.1 : 5.0;
    if (std::chrono::duration<double>(now - m_lastDrawn).count() < pause) return;
    m_lastDrawn = now;

    const double seconds = std::chrono::duration<double>(now - m_begin->time).count();
    const double share = fraction - m_begin->fraction;
    char text[120];
    int n = std::snprintf(text, sizeof(text), "%s: %zu, %.1f/s", m_what.c_str(), done,
                          static_cast<double>(done - m_begin->done) / seconds);
    if (share > 0 && n > 0)
        std::snprintf(text + n, sizeof(text) - static_cast<size_t>(n), ", %.0f %%, %.0f s left",
                      100 * std::min(fraction, 1.0), seconds * std::max(1 - fraction, 0.0) / share);
    if (m_terminal)
        std::cerr << "\r" << text << "\033[K" << std::flush;
    else
        std::cerr << text << "\n";
    m_drawn = true;
}
}  // namespace voxeland::apps
