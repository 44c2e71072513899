// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "MatchedPredictions.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <functional>

namespace voxeland
{
/** What importDataset() did. */
struct ImportSummary
{
    size_t frames = 0;              //!< written
    size_t predictions = 0;         //!< written with them
    size_t predictionsLeftOut = 0;  //!< of frames not selected or skipped
};

/** Goes through the selected frames of a dataset and writes them, each with its predictions.
 *  \param predictions matched to the dataset's frames; null: those that the dataset's annotation
 * makes, if any \param writer not closed \param progress called after each frame with the number
 * done, skipped ones included \throws InputError, OutputError as the parts do; NothingToMapError if
 * no frame is usable */
ImportSummary importDataset(RgbdDatasetReader& dataset, MatchedPredictions* predictions,
                            RgbdRawlogWriter& writer,
                            const std::function<void(size_t done)>& progress);
}  // namespace voxeland
