// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/StageTimes.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace voxeland
{
/** CPU time of every frame and stage of a run. */
class TimingLog
{
 public:
    void add(const StageTimes& times) { m_frames.push_back(times); }

    /** Reads what writeCsv() wrote. \throws InputError, naming the file, if it is anything else */
    static TimingLog fromCsv(const std::string& file);

    /** One line a frame: number and milliseconds per stage, with a header line. */
    void writeCsv(std::ostream& out) const;
    /** Median and mean per stage, and for mapping as a whole (all but detection and decoding), in
     * milliseconds. The times of refinement are those of the frames that refined; detection is left
     * out where the predictions were recorded. */
    void printSummary(std::ostream& out) const;

 private:
    /** Of the frames that had this stage. */
    [[nodiscard]] std::vector<double> timesOf(Stage stage) const;

    std::vector<StageTimes> m_frames;
};
}  // namespace voxeland
