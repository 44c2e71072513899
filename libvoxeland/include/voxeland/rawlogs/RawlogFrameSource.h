// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/FrameAssembler.h"
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/rawlogs/LabelChoice.h"
#include "voxeland/rawlogs/PredictionSidecar.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrpt::obs
{
class CObservation;
}
namespace mrpt::maps
{
class CSimpleMap;
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
    /** \param strict odd poses, predictions and pictures, which are left out and told otherwise,
     * are errors \throws InputError if a file cannot be read, ConfigurationError for an unknown
     * pose source
     */
    RawlogFrameSource(const std::string& file, const InputOptions& options, const FrameRange& range,
                      bool strict = false);
    ~RawlogFrameSource();

    /** The next frame, or none at the end.
     *  \throws InputError, naming the file, if it is cut off or damaged */
    std::optional<RgbdFrame> next();

    /** Lets the source end early, as if the range ended there, once `wanted` says so. It is asked
     * at each frame by the thread that calls next(). */
    void stopWhen(std::function<bool()> wanted) { m_stopWanted = std::move(wanted); }
    /** First frame of the range that was left out because of that; none if there is none. A range
     * from there gives what is missing. */
    [[nodiscard]] std::optional<uint32_t> stoppedBefore() const { return m_stoppedBefore; }

    /** How many frames next() will probably have given at the end, judged by the share of the file
     * that those met so far took; 0 before the first. From any thread. */
    [[nodiscard]] uint32_t expectedFrames() const { return m_expectedFrames; }
    /** RGB-D frames met so far, whether used or not. */
    [[nodiscard]] uint32_t framesMet() const { return m_framesMet; }
    /** What of the range could not be used. */
    [[nodiscard]] FrameAssembler::Counts skipped() const;
    /** What was assumed, or left out without being asked, so far: sentences for the user. */
    [[nodiscard]] std::vector<std::string> notes() const;
    /** Why frames have no pose, as far as their times tell, and what to do. */
    [[nodiscard]] std::string whyNoPoses() const;
    /** Predictions that were left out as they cannot be used. */
    [[nodiscard]] const LeftOut& oddPredictions() const { return m_assembler.oddPredictions(); }
    /** Why framesMet() is zero, and what to do. */
    [[nodiscard]] std::string whyNoFrames() const;

 private:
    /** Gives what the next object of the file holds to the assembler; false at the end. */
    bool readOn();
    void take(const std::shared_ptr<mrpt::serialization::CSerializable>& object);
    void takeObservation(const std::shared_ptr<mrpt::obs::CObservation>& observation);
    void takeScan(const std::shared_ptr<mrpt::obs::CObservation>& observation);
    void takeKeyframe(size_t index);
    /** Whether a frame of this number is not left out on purpose. */
    [[nodiscard]] bool isWanted(uint32_t number) const;
    /** Predictions between two frames belong to none; which part of a run cut in several counts
     * them is decided by the later frame. */
    void countWithoutFrame(uint32_t laterFrame);
    bool isOfTheDetector(const CObservationInstances& predictions);
    /** The first frame behind this one that is not. */
    [[nodiscard]] uint32_t nextWanted(uint32_t number) const;
    /** Ends the range behind this frame if that is wanted. */
    void stopBehind(uint32_t number);
    /** Forgets that the range was to end, where the file did before. */
    void finishStopping();
    void estimateFrames();

    std::string m_file;
    InputOptions m_options;
    FrameRange m_range;
    bool m_strict;
    LabelChoice m_cameras, m_detectors, m_poseSensors;
    std::unique_ptr<GzInputFile> m_input;
    PredictionSidecar m_sidecar;
    FrameAssembler m_assembler;
    RobotPose m_framePose{};  //!< of a sensory frame: where the actions so far have led, or the
                              //!< keyframe's
    std::shared_ptr<mrpt::maps::CSimpleMap> m_simplemap;  //!< whose keyframes are being read
    size_t m_nextKeyframe = 0;
    std::function<bool()> m_stopWanted = [] { return false; };
    std::optional<uint32_t> m_stoppedBefore;
    uint32_t m_lastAskedFor;  //!< FrameRange::to, as it was before a stop
    std::atomic<uint32_t> m_expectedFrames = 0;
    uint32_t m_framesMet = 0;
    std::vector<std::string> m_trajectoryNotes;
    uint32_t m_sidecarMatched = 0;  //!< predictions of the sidecar that a frame has
    uint32_t m_sidecarWithoutFrame =
        0;  //!< predictions of the sidecar that no scan has the timestamp of
    bool m_beyondRange = false, m_finished = false;
};
}  // namespace voxeland
