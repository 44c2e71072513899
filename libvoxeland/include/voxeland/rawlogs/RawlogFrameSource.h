// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/FrameAssembler.h"
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/rawlogs/LabelChoice.h"
#include "voxeland/rawlogs/PredictionSidecar.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrpt::obs
{
class CObservation;
}
namespace mrpt::serialization
{
class CSerializable;
}

namespace voxeland
{
class GzInputFile;

/** Which RGB-D frames of a rawlog to use, numbered from 0 as they are in it. */
struct FrameRange
{
    uint32_t from = 0;         //!< first frame
    uint32_t to = UINT32_MAX;  //!< last frame, included
    uint32_t every = 1;        //!< of those, one in so many; >= 1
};

/** Reads frames with poses and predictions from a rawlog (observations or sensory frames with
 * actions) or a .simplemap, as a stream: memory does not grow with the file. Predictions in the
 * sidecar
 *  `<name>.instances.rawlog` and images in `<name>_Images` are found beside it. */
class RawlogFrameSource
{
 public:
    /** \param strict odd poses, which are left out and told otherwise, are errors
     *  \throws InputError if a file cannot be read, ConfigurationError for an unknown pose source
     */
    RawlogFrameSource(const std::string& file, const InputOptions& options, const FrameRange& range,
                      bool strict = false);
    ~RawlogFrameSource();

    /** The next frame, or none at the end.
     *  \throws InputError, naming the file, if it is cut off or damaged */
    std::optional<RgbdFrame> next();

    /** Share of the file read so far, in [0,1]. */
    [[nodiscard]] double progress() const;
    /** RGB-D frames met so far, whether used or not. */
    [[nodiscard]] uint32_t framesMet() const { return m_framesMet; }
    /** What of the range could not be used. */
    [[nodiscard]] FrameAssembler::Counts skipped() const;
    /** What was assumed, or left out without being asked, so far: sentences for the user. */
    [[nodiscard]] std::vector<std::string> notes() const;
    /** Why frames have no pose, as far as their times tell, and what to do. */
    [[nodiscard]] std::string whyNoPoses() const;

 private:
    /** Gives what the next object of the file holds to the assembler; false at the end. */
    bool readOn();
    void take(const std::shared_ptr<mrpt::serialization::CSerializable>& object);
    void takeObservation(const std::shared_ptr<mrpt::obs::CObservation>& observation);
    void takeScan(const std::shared_ptr<mrpt::obs::CObservation>& observation);
    /** Whether a frame of this number is not left out on purpose. */
    [[nodiscard]] bool isWanted(uint32_t number) const;
    /** Predictions between two frames belong to none; which part of a run cut in several counts
     * them is decided by the later frame. */
    void countWithoutFrame(uint32_t laterFrame);
    bool isOfTheDetector(const CObservationInstances& predictions);

    std::string m_file;
    InputOptions m_options;
    FrameRange m_range;
    LabelChoice m_cameras, m_detectors, m_poseSensors;
    std::unique_ptr<GzInputFile> m_input;
    PredictionSidecar m_sidecar;
    FrameAssembler m_assembler;
    RobotPose m_framePose{};  //!< of a sensory frame: where the actions so far have led, or the
                              //!< keyframe's
    uint32_t m_framesMet = 0;
    std::vector<std::string> m_trajectoryNotes;
    uint32_t m_sidecarWithoutFrame =
        0;  //!< predictions of the sidecar that no scan has the timestamp of
    bool m_beyondRange = false, m_finished = false;
};
}  // namespace voxeland
