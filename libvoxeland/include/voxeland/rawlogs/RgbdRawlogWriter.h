// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"
#include "voxeland/observations/PoseUncertainty.h"

#include <memory>
#include <string>
#include <vector>

namespace mrpt::obs
{
class CObservation;
class CObservation3DRangeScan;
}  // namespace mrpt::obs

namespace voxeland
{
/** What goes into a rawlog for one frame. All parts carry the frame's timestamp. */
struct RgbdRecord
{
    std::shared_ptr<mrpt::obs::CObservation3DRangeScan> scan;  //!< depth and registered colour
    /** Pose of the robot in the world; the scan's sensorPose is relative to it. Null: unknown. */
    std::shared_ptr<mrpt::math::TPose3D> robotPose;
    PoseCovariance poseCovariance{};       //!< of that pose, or null
    CObservationInstances::Ptr instances;  //!< predictions, or null
    /** What other sensors say; in the rawlog it comes before the scan, odometry first. */
    std::vector<std::shared_ptr<mrpt::obs::CObservation>> others;
};

/** Writes RGB-D frames, poses and predictions as a stock MRPT rawlog (observations format, gz).
 *  Everything is written beside the target under a temporary name and put in place by close():
 *  a run that dies leaves no half-written rawlog. */
class RgbdRawlogWriter
{
 public:
    /** Where predictions and images go. */
    struct Options
    {
        /** true: predictions inside the rawlog; false: in the sidecar NAME.instances.rawlog. */
        bool embedInstances = false;
        /** true: images inside the rawlog; false: in the folder NAME_Images, loaded when needed. */
        bool embedImages = false;
        /** true: a frame's observations are a sensory frame, its odometry an action before it;
         *  false: each observation is an entry of its own. */
        bool sensoryFrames = false;
        /** Free text stored as the rawlog's first entry (CObservationComment), unless it
         *  consists of sensory frames; empty: none. */
        std::string comment;
    };

    /** \param file target, ending in .rawlog
     *  \throws OutputError if it cannot be written, ConfigurationError for another ending */
    RgbdRawlogWriter(const std::string& file, const Options& options);
    /** Removes what was written unless close() was called. */
    ~RgbdRawlogWriter();
    RgbdRawlogWriter(const RgbdRawlogWriter&) = delete;
    RgbdRawlogWriter& operator=(const RgbdRawlogWriter&) = delete;

    /** Appends a frame. The record's scan is changed: its images are moved to files. Colour is
     *  stored as JPEG of quality 95, but an image that is a file already (isExternallyStored()) is
     *  copied as it is. \throws OutputError if it cannot be written */
    void write(const RgbdRecord& record);
    /** Completes the files and puts them in place of an earlier rawlog of that name with all that
     *  belongs to it. \throws OutputError if that is not possible */
    void close();

 private:
    struct Implementation;
    std::unique_ptr<Implementation> m;
};
}  // namespace voxeland
