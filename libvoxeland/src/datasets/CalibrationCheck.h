// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace voxeland
{
/** A way to read a dataset's numbers, and how well its frames agree when read so. */
struct CalibrationReading
{
    bool invertPoses = false;  //!< the other way round than the dataset was opened
    PoseAxes axes = PoseAxes::optical;
    double depthScale = 0;   //!< numbers in a depth image that make a metre
    double focalFactor = 1;  //!< of both focal lengths

    /** Median distance, along the line of sight, between a surface as one frame measured it and as
     *  the other did [m]; infinite if too few points can be compared. */
    double disagreement = std::numeric_limits<double>::infinity();
    /** The same as a share of the measured depth: comparable between readings. */
    double relative = std::numeric_limits<double>::infinity();
    size_t points = 0;  //!< compared
};

/** What checkCalibration() found. */
struct CalibrationFinding
{
    enum class Verdict
    {
        consistent,     //!< and no other reading fits as well
        undecided,      //!< consistent, but so is another reading: the camera moves too little
        contradiction,  //!< another reading fits, or none does
        nothing         //!< no frames that could be compared
    };

    size_t pairs = 0;                        //!< of frames compared
    std::map<std::string, size_t> unusable;  //!< frames of the sample left out, by reason
    CalibrationReading asGiven;
    CalibrationReading invertedPoses;     //!< all else as given
    CalibrationReading otherAxes;         //!< the best of the poses' other axes, inverted or not
    CalibrationReading otherDepthScale;   //!< the best of the common ones
    CalibrationReading otherFocalLength;  //!< the best of some factors
    CalibrationReading best;              //!< of all, poses and scale also wrong together
    Verdict verdict = Verdict::nothing;
    std::string sentence;  //!< the verdict in words, with what to do

    /** All of it, to be read. */
    [[nodiscard]] std::string text() const;
};

/** Do depth scale, intrinsics and pose convention of a dataset hold together? Reads a sample of the
 *  selected frames, lays the surfaces that one frame measured into another one taken nearby, and
 *  compares the depths: as the dataset is read now, with its poses inverted, with poses of other
 * axes, with other common depth scales and with other focal lengths. \param progress called after
 * each frame with the number read \throws InputError as the reader does */
CalibrationFinding checkCalibration(const RgbdDatasetReader& dataset,
                                    const std::function<void(size_t read)>& progress);
}  // namespace voxeland
