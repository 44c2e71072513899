// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "MatchedPredictions.h"

#include <functional>
#include <string>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** Gives the predictions for an RGB-D frame, without timestamp, label and sensor pose; null: none.
 *  \param frame its number, from 0 */
using PredictionSource = std::function<CObservationInstances::Ptr(
    size_t frame, const mrpt::obs::CObservation3DRangeScan& scan)>;

/** How addPredictions() works. */
struct AddPredictionsOptions
{
    /** true: a new rawlog with the predictions inside; false: a sidecar beside it. */
    bool embed = false;
    /** Which sensor's RGB-D frames; empty: the only one's. */
    std::string sensorLabel;
};

/** What addPredictions() did. */
struct AddedPredictions
{
    size_t frames = 0;          //!< RGB-D frames in the rawlog
    size_t predictions = 0;     //!< added
    size_t replaced = 0;        //!< earlier prediction observations dropped from it
    bool rawlogWritten = true;  //!< false: the output is the input, left as it was
    bool imagesLinked = false;  //!< OUTPUT_Images is a link to the input's images
};

/** Adds predictions to a rawlog, in either of MRPT's rawlog formats. Its RGB-D frames are numbered
 *  from 0 in their order. Without embed, the rawlog is copied as it is, unless output is input. The
 *  input stays as it is until the output is complete, also where they are the same.
 *  \param progress called after each frame with their number and the share of the file done
 *  \throws InputError if the rawlog is missing, cut off, or holds predictions already (without
 *  embed); NothingToMapError if it has no RGB-D frames; ConfigurationError if it has several
 *  sensors' and none is chosen; OutputError */
AddedPredictions addPredictions(const std::string& input, const PredictionSource& predictions,
                                const std::string& output, const AddPredictionsOptions& options,
                                const std::function<void(size_t frames, double share)>& progress);

/** The RGB-D frames of a rawlog: their numbers, and the names of their colour images where these
 * are files of their own. \param sensorLabel which sensor's; empty: the only one's \throws as
 * addPredictions() for the input */
std::vector<DatasetFrame> rgbdFramesOf(const std::string& rawlog, const std::string& sensorLabel);

/** Predictions from a file as such a source.
 *  \param predictions matched to rgbdFramesOf() the rawlog; must live as long */
PredictionSource recordedPredictions(MatchedPredictions& predictions);
}  // namespace voxeland
