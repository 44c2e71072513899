// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/TimingLog.h"

#include "voxeland/errors.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <locale>
#include <numeric>
#include <optional>
#include <ostream>
#include <sstream>

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

std::string csvHeader()
{
    std::string header = "frame";
    for (const char* name : STAGE_NAMES) header += std::string(",") + name + "_ms";
    return header;
}

/** A line of writeCsv(); nothing if it is anything else. */
std::optional<StageTimes> parseLine(const std::string& line)
{
    std::istringstream in(line);
    in.imbue(std::locale::classic());
    size_t frame = 0;
    in >> frame;
    StageTimes times{};
    for (double& seconds : times) {
        char comma = 0;
        in >> comma >> seconds;
        seconds /= MILLISECONDS;
        if (in.fail() || comma != ',') return std::nullopt;
    }
    return in.get() == EOF ? std::optional(times) : std::nullopt;
}
}  // namespace

TimingLog TimingLog::fromCsv(const std::string& file)
{
    const auto fail = [&](const std::string& problem) {
        throw InputError("cannot read times from '" + file + "': " + problem);
    };
    std::ifstream in(file);
    if (!in) fail("there is no such file");
    std::string line;
    if (!std::getline(in, line) || line != csvHeader())
        fail("it is no file of rawlog2voxeland's --timing");
    TimingLog log;
    for (size_t number = 2; std::getline(in, line); ++number) {
        const auto times = parseLine(line);
        if (!times) fail("line " + std::to_string(number) + " is damaged");
        log.add(*times);
    }
    return log;
}

void TimingLog::writeCsv(std::ostream& out) const
{
    out << csvHeader() << "\n";
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
        const auto stage = static_cast<Stage>(s);
        if (stage == Stage::detection) continue;
        if (stage != Stage::decode)
            for (size_t f = 0; f < m_frames.size(); ++f) mapping[f] += m_frames[f][s];
        printRow(out, STAGE_NAMES[s], timesOf(stage));
    }
    printRow(out, "mapping", std::move(mapping));
    const auto detection = timesOf(Stage::detection);
    if (detection.empty()) return;
    out << "Elapsed time [ms]\n";
    printRow(out, STAGE_NAMES[static_cast<size_t>(Stage::detection)], detection);
}

std::vector<double> TimingLog::timesOf(Stage stage) const
{
    const bool isInEveryFrame = stage != Stage::refinement && stage != Stage::detection;
    std::vector<double> times;
    for (const StageTimes& frame : m_frames)
        if (const double t = frame[static_cast<size_t>(stage)]; t > 0 || isInEveryFrame)
            times.push_back(t);
    return times;
}
}  // namespace voxeland
