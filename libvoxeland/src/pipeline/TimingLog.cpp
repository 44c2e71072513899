// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/TimingLog.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>

namespace voxeland
{
namespace
{
constexpr double MILLISECONDS = 1e3;

void printRow(std::ostream& out, const char* name, std::vector<double> seconds)
{
    if (seconds.empty()) return;
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    const double mean =
        std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
    out << "  " << std::left << std::setw(14) << name << std::right << std::fixed
        << std::setprecision(3) << std::setw(9) << *middle * MILLISECONDS << std::setw(9)
        << mean * MILLISECONDS << std::setw(9) << seconds.size() << "\n";
}
}  // namespace

void TimingLog::writeCsv(std::ostream& out) const
{
    out << "frame";
    for (const char* name : STAGE_NAMES) out << "," << name << "_ms";
    out << "\n";
    for (size_t f = 0; f < m_frames.size(); ++f) {
        out << f;
        for (const double seconds : m_frames[f]) out << "," << seconds * MILLISECONDS;
        out << "\n";
    }
}

void TimingLog::printSummary(std::ostream& out) const
{
    out << "CPU time [ms]     median     mean   frames\n";
    std::vector<double> mapping(m_frames.size(), 0);
    for (size_t s = 0; s < STAGES; ++s) {
        std::vector<double> times;
        for (size_t f = 0; f < m_frames.size(); ++f) {
            const double t = m_frames[f][s];
            if (s != static_cast<size_t>(Stage::decode)) mapping[f] += t;
            if (t > 0 || s != static_cast<size_t>(Stage::refinement)) times.push_back(t);
        }
        printRow(out, STAGE_NAMES[s], std::move(times));
    }
    printRow(out, "mapping", std::move(mapping));
}
}  // namespace voxeland
