// SPDX-License-Identifier: BSD-3-Clause
#include "TimingLog.h"

#include "files/Csv.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/numbers.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <optional>
#include <ostream>

namespace voxeland
{
namespace
{
constexpr double MILLISECONDS = 1e3;
constexpr int DECIMALS = 4;  // of a millisecond: no clock is finer in practice

void printRow(std::ostream& out, const char* name, std::vector<double> seconds)
{
    if (seconds.empty()) return;
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    const double mean =
        std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
    out << "  " << std::left << std::setw(14) << name << std::right;
    for (const double value : {*middle, mean})
        out << std::setw(9) << fixedText(value * MILLISECONDS, 3);
    out << std::setw(9) << std::to_string(seconds.size()) << "\n";
}

std::vector<std::string> csvHeader()
{
    std::vector<std::string> header = {"frame"};
    for (const char* name : STAGE_NAMES) header.push_back(std::string(name) + "_ms");
    return header;
}

/** A row of writeCsv(); nothing if it is anything else. */
std::optional<StageTimes> stageTimesOf(const std::vector<std::string>& fields)
{
    StageTimes times{};
    if (!parsed<size_t>(fields[0])) return std::nullopt;
    for (size_t stage = 0; stage < STAGES; ++stage) {
        const auto milliseconds = parsed<double>(fields[stage + 1]);
        if (!milliseconds) return std::nullopt;
        times[stage] = *milliseconds / MILLISECONDS;
    }
    return times;
}
}  // namespace

TimingLog TimingLog::fromCsv(const std::string& file)
{
    TimingLog log;
    const std::string name = "rawlog2voxeland's --timing " + file;
    for (const CsvRow& row : parseCsv(readTextFile(file, "times"), csvHeader(), name)) {
        const auto times = stageTimesOf(row.fields);
        if (!times)
            throw InputError("line " + std::to_string(row.line) + " of " + name + " is damaged");
        log.add(*times);
    }
    return log;
}

void TimingLog::writeCsv(std::ostream& out) const
{
    out << joined(csvHeader(), ",") << "\n";
    for (size_t f = 0; f < m_frames.size(); ++f) {
        out << std::to_string(f);
        for (const double seconds : m_frames[f])
            out << "," << fixedText(seconds * MILLISECONDS, DECIMALS);
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
