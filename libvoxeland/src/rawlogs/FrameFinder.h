// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/RgbdFrame.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace mrpt::serialization
{
class CSerializable;
}

namespace voxeland
{
class GzInputFile;

/** Finds some frames of a rawlog or simplemap again, by their timestamps, with their predictions
 * where there are any. Poses are not needed; memory does not grow with the file. */
class FrameFinder
{
 public:
    using Times = std::set<mrpt::Clock::time_point>;

    /** \throws InputError if a file cannot be read */
    FrameFinder(const std::string& file, const InputOptions& options, Times wanted);
    ~FrameFinder();

    /** The next of the frames wanted, or none at the end. Its pose has no
     * meaning. \throws InputError, naming the file, if it is cut off or damaged */
    std::optional<RgbdFrame> next();

    /** Share of the file read so far, in [0,1]. */
    [[nodiscard]] double progress() const;

 private:
    void take(const std::shared_ptr<mrpt::serialization::CSerializable>& object);
    void takeObservation(const std::shared_ptr<mrpt::obs::CObservation>& observation);

    std::string m_file;
    InputOptions m_options;
    Times m_wanted;
    std::unique_ptr<GzInputFile> m_input;
    std::map<mrpt::Clock::time_point, std::shared_ptr<const CObservationInstances>> m_predictions;
    std::deque<RgbdFrame> m_waiting;  //!< frames whose predictions may follow
    bool m_ended = false;
};
}  // namespace voxeland
