// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/mrpt_compat.h"
#include "voxeland/observations/FrameAssembler.h"
#include "voxeland/pipeline/SemanticMapper.h"

#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>
#include <mrpt/maps/metric_map_types.h>

#include <memory>
#include <optional>
#include <string>

namespace mrpt::maps
{
class CSimplePointsMap;
}

namespace voxeland
{
/** The semantic voxel map as MRPT knows maps: owns the map and what fills it. MRPT's programs make
 * one where their INI says `voxelandMap_count = 1`; section `<prefix>_voxelandMap_00_creationOpts`
 * may name a whole Voxeland INI (`config = file.ini`), and sections `<prefix>_voxelandMap_00_map`,
 * `..._converter` and so on set single keys.
 *
 *  Depth scans and predictions come in separate insertObservation() calls, in either order; a scan
 * waits for its predictions while a few newer ones come (`prediction_wait`), see flush(). */
class CVoxelandMap : public mrpt::maps::CMetricMap
{
    DEFINE_SERIALIZABLE(CVoxelandMap, voxeland)

 public:
    /** An empty map with default configuration; plugins are loaded when they are first needed. */
    CVoxelandMap();
    /** An empty map with a checked configuration. */
    explicit CVoxelandMap(const MapperConfig& config);

    [[nodiscard]] const SemanticVoxelMap& map() const { return m_map; }
    /** For those who change what is known of instances or categories. */
    [[nodiscard]] SemanticVoxelMap& editMap() { return m_map; }
    [[nodiscard]] const MappingCounts& counts() const { return m_counts; }
    /** INI text that reproduces the map's configuration; empty: all defaults. */
    [[nodiscard]] const std::string& configText() const { return m_configText; }

    /** Goes on with another configuration. \throws ConfigurationError if the map was built with
     * another resolution or occupancy model */
    void setConfig(const MapperConfig& config);

    /** What fills the map, made from the configuration when first needed.
     *  \throws PluginError, ConfigurationError */
    const SemanticMapper& mapper();
    /** Adds a frame prepared by mapper(). \return its stage times */
    StageTimes integrate(PreparedFrame frame);

    /** Lets integrate() tell why it decides as it does, until the configuration changes.
     *  \param trace null: no more */
    void setTrace(std::shared_ptr<MappingTrace> trace);

    /** Remembers frames and predictions that could not be used. */
    void addSkipped(const FrameAssembler::Counts& skipped);

    /** Maps the scans that still wait for predictions or a pose, without them. */
    void flush();

    /** \name CMetricMap @{ */
    [[nodiscard]] bool isEmpty() const override { return m_map.empty(); }
    [[nodiscard]] std::string asString() const override;
    /** Occupied voxels as cubes, coloured by instance. */
    void getVisualizationInto(mrpt::opengl::CSetOfObjects& out) const override;
    /** Writes `<prefix>.voxeland` (with waiting frames mapped) and, unless disabled in the generic
     * map parameters, `<prefix>.3Dscene`. */
    void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
    /** Centres of occupied voxels; kept until the map changes. */
    [[nodiscard]] const mrpt::maps::CSimplePointsMap* getAsSimplePointsMap() const override;
    /** Share of the other map's points (those of getAsSimplePointsMap()) that fall in an occupied
     * voxel or next to one, in [0,1]. \throws std::runtime_error if the other map cannot be seen as
     * points */
    [[nodiscard]] float compute3DMatchingRatio(
        const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
        const mrpt::maps::TMatchingRatioParams& params) const override;
    /** @} */

    MAP_DEFINITION_START(CVoxelandMap)
    std::string ini;  //!< text of the Voxeland INI
    MAP_DEFINITION_END(CVoxelandMap)

 private:
    void internal_clear() override;
    /** Takes CObservation3DRangeScan and CObservationInstances, ignores all else. `robotPose` is
     * that of the robot when the observation was made. */
    bool internal_insertObservation(
        const mrpt::obs::CObservation& observation,
        const std::optional<const mrpt::poses::CPose3D>& robotPose = std::nullopt) override;
    /** Log-likelihood of a 2D or 3D range scan: mean over its points of ln(0.05 + 0.95 p), p being
     * the occupancy of the voxel the point falls in, scaled by the number of points used. */
    double internal_computeObservationLikelihood(
        const mrpt::obs::CObservation& observation,
        const mrpt::poses::CPose3D& takenFrom) const override;
    bool internal_canComputeObservationLikelihood(
        const mrpt::obs::CObservation& observation) const override;
    void mapCompleteFrames();
    void startAssembler();

    std::string m_configText;
    SemanticVoxelMap m_map;
    MappingCounts m_counts;
    FrameAssembler m_assembler;
    std::optional<SemanticMapper> m_mapper;
    mutable std::shared_ptr<mrpt::maps::CSimplePointsMap> m_points;
};
}  // namespace voxeland
