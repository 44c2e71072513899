// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/RawlogMapping.h"

#include "base/timeText.h"
#include "pipeline/FramePredictor.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/observations/UnusableFrame.h"

#include <utility>

namespace voxeland
{
namespace
{
/** Gives a rawlog's frames as a mapper takes them: with poses in the map's frame. */
class PlacedFrames
{
 public:
    /** Places the map, if it is empty, near the first frame. */
    PlacedFrames(RawlogFrameSource& source, CVoxelandMap& map)
        : m_source(source), m_ahead(source.next())
    {
        if (m_ahead) map.placeNear(m_ahead->robotPose);
        m_origin = map.map().origin();
    }
    std::optional<RgbdFrame> next()
    {
        auto frame = std::exchange(m_ahead, std::nullopt);
        if (!frame) frame = m_source.next();
        if (frame) frame->robotPose = relativeTo(m_origin, frame->robotPose);
        return frame;
    }

 private:
    RawlogFrameSource& m_source;
    std::optional<RgbdFrame> m_ahead;  //!< the first frame
    mrpt::math::TPoint3D
        m_origin;  //!< of the map's frame, kept here as the map itself changes meanwhile
};

void checkSomethingMapped(const RawlogFrameSource& source, bool mapped)
{
    if (mapped) return;
    if (source.framesMet() == 0) throw NothingToMapError(source.whyNoFrames());
    if (source.skipped().framesWithoutPose == 0)
        throw NothingToMapError("none of the rawlog's " + std::to_string(source.framesMet()) +
                                " frames is in the range asked for");
    throw NothingToMapError("none of the rawlog's " + std::to_string(source.framesMet()) +
                            " frames has a pose: " + source.whyNoPoses());
}

/** The next frame that measured something; those before are left out.
 *  \param unreadable set if one of them is left out for another reason */
std::optional<PreparedFrame> nextUsable(FramePreparer& preparer, LeftOut& leftOut, bool& unreadable)
{
    for (;;) {
        try {
            auto frame = preparer.next();
            if (!frame || frame->voxels.depths().pixels > 0) return frame;
            leftOut.add("the frame of " + timeText(frame->time) +
                        " measured nothing: all of its depth image is unknown");
        } catch (const UnusableFrame& e) {
            unreadable = true;
            leftOut.add(e.what());
        }
    }
}

[[noreturn]] void failWithoutFrames(const LeftOut& leftOut, bool unreadable)
{
    if (unreadable) throw InputError(leftOut.first());
    throw NothingToMapError("none of the rawlog's frames can be mapped: " + leftOut.first());
}

void checkDepths(const DepthsMet& met, const DepthLimits& limits)
{
    if (met.used > 0) return;
    throw NothingToMapError(
        "no depth lies between min_depth and max_depth, " + numberText(limits.min_depth) + " and " +
        numberText(limits.max_depth) + " m; those met are of " + fixedText(met.nearest, 3) +
        " to " + fixedText(met.farthest, 3) + " m: correct the scans' rangeUnits, or these limits");
}
}  // namespace

void SurfaceAgreement::add(const VoxelizedFrame& frame, const SemanticVoxelMap& map)
{
    constexpr size_t SAMPLED = 8;  // one hit voxel in so many
    for (size_t h = 0; h < frame.hits().size(); h += SAMPLED) {
        const log_odds_t before = map.occupancy(frame.hits()[h].coord);
        if (OccupancyFilter::isOccupied(before)) ++agreeing;
        if (OccupancyFilter::isFree(before)) ++contradicting;
    }
}

MappedInput mapRawlog(RawlogFrameSource& source, CVoxelandMap& map,
                      const std::function<void(const StageTimes&)>& onFrame, bool strict)
{
    MappedInput met;
    met.leftOut = LeftOut(strict);
    bool mapped = false, unreadable = false;
    {
        const SemanticMapper& mapper = map.mapper();
        PlacedFrames frames(source, map);
        FramePredictor predictor(mapper, [&] { return frames.next(); });
        FramePreparer preparer(
            mapper,
            [&] {
                auto frame = predictor.next();
                if (frame && frame->instances)
                    met.predictions += frame->instances->instances.size();
                return frame;
            },
            mapper.config().input.threads);
        while (auto frame = nextUsable(preparer, met.leftOut, unreadable)) {
            met.depths.add(frame->voxels.depths());
            met.opinions += frame->opinions.size();
            mapped = true;
            if (map.holds(*frame)) {
                ++met.repeated;
                continue;
            }
            met.surfaces.add(frame->voxels, map.map());
            onFrame(map.integrate(std::move(*frame)));
        }
    }
    if (!source.stoppedBefore()) {
        if (!mapped && met.leftOut.count() > 0) failWithoutFrames(met.leftOut, unreadable);
        checkSomethingMapped(source, mapped);
        if (met.predictions == 0 && source.oddPredictions().count() > 0)
            throw InputError("none of the predictions can be used: " +
                             source.oddPredictions().first());
        checkDepths(met.depths, map.mapper().config().input.depth);
    }
    map.addSkipped(source.skipped());
    return met;
}
}  // namespace voxeland
