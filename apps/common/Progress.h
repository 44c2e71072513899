// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace voxeland::apps
{
/** Shows on stderr how far a long job is, with rate and time left: one line redrawn in place on a
 *  terminal, a plain line every few seconds otherwise. */
class Progress
{
 public:
    /** \param what what is counted, e.g. "frames"
     *  \param total how many there will be, 0 if that is not known
     *  \param shown false: stay silent (--quiet) */
    Progress(std::string what, size_t total, bool shown);
    /** Ends the line. */
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /** \param done how many are done
     *  \param fraction share of the whole job, in [0,1]; negative: done/total */
    void update(size_t done, double fraction = -1);

 private:
    using clock = std::chrono::steady_clock;

    std::string m_what;
    size_t m_total;
    bool m_shown, m_terminal, m_drawn = false;
    /** The first update: what came before it, as skipping frames, tells nothing of the rate. */
    struct Begin
    {
        clock::time_point time;
        size_t done;
        double fraction;
    };
    std::optional<Begin> m_begin;
    clock::time_point m_lastDrawn;
};
}  // namespace voxeland::apps
