// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/SemanticMapper.h"

#include "Integration.h"
#include "MappingTrace.h"
#include "Refinement.h"
#include "observations/DepthImageCheck.h"
#include "observations/DepthImageFile.h"
#include "observations/MaskCamera.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/UnusableFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <chrono>
#include <cmath>
#include <utility>

namespace voxeland
{
namespace
{
/** Whether voxels that a frame saw can all be stored. */
bool isInRange(const ObservedSpace& space)
{
    for (size_t b = 0; b < space.size(); ++b)
        if (!voxeland::isInRange(space.coordOf(b))) return false;
    return true;
}

void checkRange(const RgbdFrame& frame, bool inRange)
{
    if (!inRange)
        throw UnusableFrame(frameName(*frame.scan) +
                            " lies farther off than the map can hold: map it on its own");
}

/** Plugins are other people's code: what they return must not spoil a map. */
void checkOpinions(const std::vector<Opinion>& opinions, const VoxelizedFrame& voxels,
                   const COpinionConverter& converter)
{
    for (const Opinion& o : opinions) {
        bool valid = o.confidence > 0 && o.confidence <= 1 && !o.voxels.empty();
        for (const OpinionVoxel& v : o.voxels)
            valid =
                valid && v.hit < voxels.hits().size() && v.points > 0 && std::isfinite(v.points);
        if (!valid)
            throw PluginError(
                std::string(converter.GetRuntimeClass()->className) +
                " made an opinion without voxels, points or confidence: correct the plugin");
    }
}

void checkAssignments(const std::vector<Assignment>& assignments, size_t opinions,
                      const SemanticVoxelMap& map, const CAssociationPolicy& policy)
{
    bool valid = assignments.size() == opinions;
    for (const Assignment& a : assignments)
        valid = valid && (a.instance == UNKNOWN_INSTANCE || map.instances().count(a.instance) != 0);
    if (!valid)
        throw PluginError(
            std::string(policy.GetRuntimeClass()->className) +
            " did not assign every opinion to an instance that exists: correct the plugin");
}
}  // namespace

void SemanticMapper::predict(RgbdFrame& frame) const
{
    if (!m_config.converter->makesPredictions()) return;
    const auto start = std::chrono::steady_clock::now();
    const auto predictions = m_config.converter->predict(*frame.scan);
    if (predictions) attachToScan(*predictions, *frame.scan);
    frame.instances = predictions;
    frame.detectionTime =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

PreparedFrame SemanticMapper::prepare(const RgbdFrame& frame) const
{
    StageTimes times{};
    times[static_cast<size_t>(Stage::detection)] = frame.detectionTime;
    {
        const StageTimer timer(times, Stage::decode);
        loadDepthImage(*frame.scan);
    }
    const double resolution = m_config.map.resolution;
    const auto camera = (frame.robotPose + frame.scan->sensorPose).translation();
    checkRange(frame, voxeland::isInRange(camera, 1 / resolution));

    auto voxels = [&] {
        const StageTimer timer(times, Stage::voxelize);
        return VoxelizedFrame(frame, resolution, m_config.input.depth);
    }();
    auto opinions = [&] {
        const StageTimer timer(times, Stage::opinions);
        return m_config.converter->convert(frame, voxels);
    }();
    checkOpinions(opinions, voxels, *m_config.converter);
    auto space = [&] {
        const StageTimer timer(times, Stage::rays);
        try {
            return castRays(voxels, m_config.integration.visibility_margin);
        } catch (const UnusableFrame& e) {
            throw UnusableFrame(frameName(*frame.scan) + ": " + e.what());
        }
    }();
    checkRange(frame, isInRange(space));
    std::optional<PoseUncertainty> uncertainty;
    if (m_config.integration.pose_uncertainty && frame.poseCovariance)
        uncertainty.emplace(frame.robotPose, *frame.poseCovariance);
    return {std::move(voxels),
            std::move(opinions),
            std::move(space),
            frame.instances != nullptr,
            times,
            frame.scan->timestamp,
            uncertainty};
}

StageTimes SemanticMapper::integrate(PreparedFrame frame, SemanticVoxelMap& map,
                                     MappingCounts& counts)
{
    std::vector<OpinionOverlaps> opinions;
    std::vector<Assignment> assignments;
    {
        const StageTimer timer(frame.times, Stage::association);
        opinions = m_overlaps.find(frame, m_config.integration.sharpness, map);
        assignments = m_config.association->associate(opinions, map);
        checkAssignments(assignments, opinions.size(), map, *m_config.association);
    }
    {
        const StageTimer timer(frame.times, Stage::integration);
        const auto instances = resolveAssignments(assignments, map);
        if (m_trace) m_trace->opinions(counts.frames, opinions, assignments, instances);
        integrateOccupancy(frame.space, map, frame.uncertainty);
        const IntegrationOptions& options = m_config.integration;
        const auto missed = m_overlaps.missed(instances, options.missed_share, map);
        integrateGeometry(frame, instances, missed, options, map);
        integrateSemantics(frame, opinions, instances, counts.frames, options, map);
        recordViews(frame, opinions, instances, counts.frames, map);
    }
    ++counts.frames;
    counts.framesWithoutPredictions += frame.hasPredictions ? 0 : 1;
    counts.opinions += static_cast<uint32_t>(frame.opinions.size());
    const uint32_t every = m_config.refinement.every;
    if (every > 0 && counts.frames % every == 0) {
        const StageTimer timer(frame.times, Stage::refinement);
        const uint32_t sinceFrame = counts.frames - every;
        const bool isFirst = std::exchange(m_refinedAt, counts.frames) != sinceFrame;
        refine(map, *m_config.association, m_config.refinement, sinceFrame, isFirst, counts,
               m_trace.get());
    }
    return frame.times;
}
}  // namespace voxeland
