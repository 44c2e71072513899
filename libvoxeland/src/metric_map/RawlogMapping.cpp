// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/RawlogMapping.h"

#include "voxeland/errors.h"
#include "voxeland/pipeline/FramePredictor.h"

namespace voxeland
{
namespace
{
void checkSomethingMapped(const RawlogFrameSource& source, bool mapped)
{
    if (mapped) return;
    if (source.framesMet() == 0)
        throw NothingToMapError(
            "the rawlog holds no CObservation3DRangeScan of the sensor to map: check "
            "depth_sensor_label");
    if (source.skipped().framesWithoutPose == 0)
        throw NothingToMapError("none of the rawlog's " + std::to_string(source.framesMet()) +
                                " frames is in the range asked for");
    throw NothingToMapError(
        "none of the rawlog's " + std::to_string(source.framesMet()) +
        " frames has a pose: check pose_source, or give a trajectory with --poses");
}
}  // namespace

void mapRawlog(
    RawlogFrameSource& source, CVoxelandMap& map,
    const std::function<void(const mrpt::Clock::time_point&, const StageTimes&)>& onFrame)
{
    bool mapped = false;
    {
        const SemanticMapper& mapper = map.mapper();
        FramePredictor predictor(mapper, [&] { return source.next(); });
        FramePreparer preparer(
            mapper, [&] { return predictor.next(); }, mapper.config().input.threads);
        while (auto frame = preparer.next()) {
            const auto time = frame->time;
            onFrame(time, map.integrate(std::move(*frame)));
            mapped = true;
        }
    }
    checkSomethingMapped(source, mapped);
    map.addSkipped(source.skipped());
}

std::set<mrpt::Clock::time_point> timesOfViews(const SemanticVoxelMap& map)
{
    std::set<mrpt::Clock::time_point> times;
    for (const auto& [id, instance] : map.instances())
        for (const auto& [category, views] : instance.views.byCategory())
            for (const InstanceView& view : views) times.insert(view.time);
    return times;
}
}  // namespace voxeland
