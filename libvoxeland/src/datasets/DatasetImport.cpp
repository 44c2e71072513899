// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetImport.h"

#include "observations/MaskCamera.h"
#include "voxeland/base/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <future>
#include <optional>

namespace voxeland
{
namespace
{
/** A frame as read, with the number of frames gone through so far. */
struct ReadFrame
{
    RgbdRecord record;
    size_t position;
    size_t done;
};

void attachPredictions(MatchedPredictions& predictions, ReadFrame& read)
{
    const auto& scan = *read.record.scan;
    const auto& camera = maskCamera(scan);
    read.record.instances = predictions.instancesFor(read.position, static_cast<int>(camera.ncols),
                                                     static_cast<int>(camera.nrows));
    if (read.record.instances) attachToScan(*read.record.instances, scan);
}
}  // namespace

ImportSummary importDataset(RgbdDatasetReader& dataset, MatchedPredictions* predictions,
                            RgbdRawlogWriter& writer,
                            const std::function<void(size_t done)>& progress)
{
    ImportSummary summary;
    // Decoding the next frame takes as long as compressing this one: do both at a time.
    size_t usable = 0;
    const auto readNext = [&]() -> std::optional<ReadFrame> {
        RgbdRecord record;
        if (!dataset.next(record)) return std::nullopt;
        return ReadFrame{record, dataset.position(), ++usable + dataset.skipped().size()};
    };
    if (predictions)
        for (size_t i = 0; i < dataset.frames().size(); ++i)
            summary.predictionsLeftOut += predictions->countFor(i);
    for (auto read = readNext(); read;) {
        auto next = std::async(std::launch::async, readNext);
        if (predictions) {
            attachPredictions(*predictions, *read);
            summary.predictionsLeftOut -= predictions->countFor(read->position);
        }
        if (read->record.instances) summary.predictions += read->record.instances->instances.size();
        writer.write(read->record);
        ++summary.frames;
        progress(read->done);
        read = next.get();
    }
    if (summary.frames == 0)
        throw NothingToMapError("no frame can be used" +
                                (dataset.skipped().empty() ? ": none is selected"
                                                           : ", the first because of: " +
                                                                 dataset.skipped().front().reason));
    return summary;
}
}  // namespace voxeland
