// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/CVoxelandMap.h"

#include "UsersConfigurations.h"
#include "WarnOnce.h"
#include "exporters/MapScene.h"
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/printable.h"
#include "voxeland/level/GravityAlignedFrame.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/metric_map/MapFile.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/serialization/CArchive.h>

#include <sstream>

using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::poses::CPose3D;

namespace voxeland
{
IMPLEMENTS_SERIALIZABLE(CVoxelandMap, mrpt::maps::CMetricMap, voxeland)
const RegisteredClass<CVoxelandMap> REGISTERED;

namespace
{
void warnOfAnotherCamera(const std::string& refused, const std::string& mapped)
{
    warnOnce("scans of '" + printable(refused) + "' are left out, as those of '" +
             printable(mapped) + "' came first: name the camera to map as depth_sensor_label");
}
}  // namespace

CVoxelandMap::CVoxelandMap()
    : m_assembler(InputOptions().prediction_wait, InputOptions().max_pose_gap)
{
}

CVoxelandMap::CVoxelandMap(const MapperConfig& config) : CVoxelandMap()
{
    setConfig(config);
}

void CVoxelandMap::setConfig(const MapperConfig& config)
{
    try {
        m_map.edit().setOptions(config.map);
    } catch (const std::invalid_argument& e) {
        throw ConfigurationError(std::string("[map] ") + e.what());
    }
    if (config.calibration) m_map.edit().setCalibration(*config.calibration);
    m_configText = config.reproducibleText();
    UsersConfigurations::add(config);
    m_mapper.emplace(config);
    m_assembler.setLimits(config.input.prediction_wait, config.input.max_pose_gap);
}

SemanticVoxelMap& CVoxelandMap::editMap()
{
    if (m_mapper) m_mapper->mapWasEdited();
    return m_map.edit();
}

const SemanticMapper& CVoxelandMap::mapper()
{
    if (m_mapper) return *m_mapper;
    // MRPT's programs copy maps by writing and reading them: the user's choices must survive that.
    if (const auto known = UsersConfigurations::find(m_configText))
        setConfig(*known);
    else
        setConfig(MapperConfig(Ini::fromMap(m_configText, "a map that was read"),
                               MapperConfig::Purpose::mapping, warnOnce));
    return *m_mapper;
}

void CVoxelandMap::placeNear(const CPose3D& pose)
{
    if (m_map->empty()) m_map.edit().placeNear(pose.translation());
}

bool CVoxelandMap::holds(const PreparedFrame& frame) const
{
    return m_frames.has(frame.time, frame.voxels.origin());
}

StageTimes CVoxelandMap::integrate(PreparedFrame frame)
{
    if (!m_frames.add(frame.time, frame.voxels.origin())) return frame.times;
    mapper();
    return m_mapper->integrate(std::move(frame), m_map.edit(), m_counts);
}

void CVoxelandMap::setTrace(std::shared_ptr<MappingTrace> trace)
{
    mapper();
    m_mapper->setTrace(std::move(trace));
}

void CVoxelandMap::flush()
{
    m_assembler.finish();
    mapCompleteFrames();
    addSkipped(m_assembler.counts());
    startAssembler();
}

void CVoxelandMap::addSkipped(const FrameAssembler::Counts& skipped)
{
    m_counts.framesWithoutPose += skipped.framesWithoutPose;
    m_counts.predictionsWithoutFrame += skipped.predictionsWithoutFrame;
}

void CVoxelandMap::mapCompleteFrames()
{
    while (auto frame = m_assembler.next()) {
        placeNear(frame->robotPose);
        frame->robotPose = relativeTo(m_map->origin(), frame->robotPose);
        mapper().predict(*frame);
        integrate(mapper().prepare(*frame));
    }
}

void CVoxelandMap::internal_clear()
{
    m_map.edit().clear();
    m_counts = {};
    m_frames = {};
    m_camera.reset();
    startAssembler();
}

void CVoxelandMap::startAssembler()
{
    const InputOptions input = m_mapper ? m_mapper->config().input : InputOptions();
    m_assembler = FrameAssembler(input.prediction_wait, input.max_pose_gap);
}

InputOptions CVoxelandMap::withCamera(InputOptions options) const
{
    if (options.depth_sensor_label.empty()) options.depth_sensor_label = m_camera.value_or("");
    return options;
}

bool CVoxelandMap::isOfTheCamera(const CObservation3DRangeScan& scan)
{
    const std::string& named = mapper().config().input.depth_sensor_label;
    if (!named.empty()) return scan.sensorLabel == named;
    if (!m_camera && scan.hasRangeImage) m_camera = scan.sensorLabel;
    if (m_camera && *m_camera != scan.sensorLabel) warnOfAnotherCamera(scan.sensorLabel, *m_camera);
    return m_camera == scan.sensorLabel;
}

bool CVoxelandMap::internal_insertObservation(const CObservation& observation,
                                              const std::optional<const CPose3D>& robotPose)
{
    if (const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation)) {
        if (!isOfTheCamera(*scan)) return false;
        m_assembler.addScan(std::make_shared<CObservation3DRangeScan>(*scan), nullptr,
                            RobotPose{robotPose.value_or(CPose3D()).asTPose(), nullptr});
    } else if (const auto* instances = dynamic_cast<const CObservationInstances*>(&observation)) {
        const std::string& wanted = mapper().config().input.instances_sensor_label;
        if (!wanted.empty() && wanted != instances->sensorLabel) return false;
        m_assembler.addInstances(std::make_shared<CObservationInstances>(*instances));
    } else {
        return false;
    }
    mapCompleteFrames();
    return true;
}

std::string CVoxelandMap::asString() const
{
    std::ostringstream text;
    text << "voxeland map: evidence for " << counted(m_map->instances().size(), "instance")
         << " of " << counted(m_map->categories().size(), "category", "categories") << ", "
         << counted(m_counts.frames, "frame") << ", voxels of " << numberText(m_map->resolution())
         << " m";
    return text.str();
}

void CVoxelandMap::getVisualizationInto(mrpt::opengl::CSetOfObjects& out) const
{
    if (!genericMapParams.enableSaveAs3DObject) return;
    const auto cubes = voxelCubes(*m_map);
    cubes->setLocation(m_map->origin());
    out.insert(cubes);
}

void CVoxelandMap::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
    CVoxelandMap complete(*this);
    if (!m_assembler.empty()) complete.setTrace(nullptr);
    while (!complete.m_assembler.empty()) {
        try {
            complete.flush();
        } catch (const InputError&) {
            // One frame that cannot be mapped must not keep the rest from being saved.
        }
    }
    saveMap(complete, prefix + ".voxeland");
    if (!genericMapParams.enableSaveAs3DObject) return;
    const GravityAlignedFrame frame(estimateUp(complete.map()));
    exportScene(complete.map(), frame, prefix + ".3Dscene");
}

const mrpt::maps::CSimplePointsMap* CVoxelandMap::getAsSimplePointsMap() const
{
    return m_map->origin() == mrpt::math::TPoint3D() ? &m_map.points() : nullptr;
}
}  // namespace voxeland
