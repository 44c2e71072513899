// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/mrpt_compat.h"
#include "voxeland/map/MappedFrames.h"
#include "voxeland/metric_map/LikelihoodOptions.h"
#include "voxeland/metric_map/SharedVoxelMap.h"
#include "voxeland/observations/FrameAssembler.h"
#include "voxeland/pipeline/SemanticMapper.h"

#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>
#include <mrpt/maps/metric_map_types.h>
#include <mrpt/math/TBoundingBox.h>

#include <memory>
#include <optional>
#include <string>

namespace voxeland
{
/** The semantic voxel map as MRPT knows maps: owns the map and what fills it. MRPT's programs make
 * one where their INI says `voxelandMap_count = 1`; section `<prefix>_voxelandMap_00_creationOpts`
 * may name a map to begin with (`load = file.voxeland`) and a whole Voxeland INI (`config =
 * file.ini`; without it, that of the loaded map as far as it may choose, see OptionList, or the
 * defaults), and sections
 * `<prefix>_voxelandMap_00_map`, `..._converter`, `..._likelihoodOpts` and so on set single keys.
 * Likelihoods are as the loaded map's options say, but for those keys. Unknown keys and sections
 * are a ConfigurationError.
 *
 *  Scans are those of one camera, `depth_sensor_label` or else the first one met with depth images,
 * which then stays with the map until it is cleared; what is left out is told once on stderr.
 *
 *  Depth scans and predictions come in separate insertObservation() calls, in either order; a scan
 * waits for its predictions while a few newer ones come (`prediction_wait`), see flush().
 *
 *  Copies share the voxels and instances until one of them is changed. A CMultiMetricMap, though,
 * copies its maps by writing and reading them: its copies cost time and memory. */
class CVoxelandMap : public mrpt::maps::CMetricMap
{
    DEFINE_SERIALIZABLE(CVoxelandMap, voxeland)

 public:
    /** Version of what is written to files. */
    static constexpr uint8_t FORMAT = 5;
    /** The oldest version that is still read. */
    static constexpr uint8_t OLDEST_FORMAT = 2;

    /** An empty map with default configuration; plugins are loaded when they are first needed. */
    CVoxelandMap();
    /** An empty map with a checked configuration. */
    explicit CVoxelandMap(const MapperConfig& config);

    using TLikelihoodOptions = LikelihoodOptions;
    TLikelihoodOptions likelihoodOptions;  //!< of computeObservationLikelihood()

    [[nodiscard]] const SemanticVoxelMap& map() const { return *m_map; }
    /** For those who change what is known of instances or categories. The reference must not be
     * kept until after this is copied (copies share the map), nor until after points, likelihoods
     * or matches were asked for (they would not follow). */
    [[nodiscard]] SemanticVoxelMap& editMap();
    [[nodiscard]] const MappingCounts& counts() const { return m_counts; }
    /** INI text that reproduces the map's configuration; empty: all defaults. */
    [[nodiscard]] const std::string& configText() const { return m_configText; }

    /** Options for reading a rawlog into this map: of the camera that its scans are of, unless the
     *  options name one. */
    [[nodiscard]] InputOptions withCamera(InputOptions options) const;

    /** Goes on with another configuration. \throws ConfigurationError if the map was built with
     * another resolution or occupancy model */
    void setConfig(const MapperConfig& config);

    /** What fills the map, made from the configuration when first needed. That of a map that was
     * read counts as far as a map may choose, see OptionList, unless it is one that was set in this
     * process; what is left out is told once on stderr. \throws PluginError, ConfigurationError */
    const SemanticMapper& mapper();
    /** Chooses the place of an empty map in the world, see SemanticVoxelMap::placeNear(). Comes
     * before the first frame. \param pose of its robot, in the world */
    void placeNear(const mrpt::poses::CPose3D& pose);
    /** Whether the map was made from this frame already. \param frame as for integrate() */
    [[nodiscard]] bool holds(const PreparedFrame& frame) const;
    /** Adds a frame prepared by mapper() with a pose in the map's frame, unless the map holds() it:
     * seen again nothing is learnt from it. \return its stage times */
    StageTimes integrate(PreparedFrame frame);

    /** Lets integrate() tell why it decides as it does, until the configuration changes.
     *  \param trace null: no more */
    void setTrace(std::shared_ptr<MappingTrace> trace);

    /** Remembers frames and predictions that could not be used. */
    void addSkipped(const FrameAssembler::Counts& skipped);

    /** Maps the scans that still wait for predictions or a pose, without them. */
    void flush();

    /** \name CMetricMap
     *  What waits for predictions (see flush()) is part of none of these but
     * saveMetricMapRepresentationToFile(). auxParticleFilterCleanUp() does nothing: what is kept
     * for likelihoods goes when the map changes.
     *  @{ */
    [[nodiscard]] bool isEmpty() const override { return m_map->empty(); }
    [[nodiscard]] std::string asString() const override;
    /** Occupied voxels as cubes, coloured by instance. */
    void getVisualizationInto(mrpt::opengl::CSetOfObjects& out) const override;
    /** Writes `<prefix>.voxeland` (with waiting frames mapped, but for those that cannot be) and,
     * unless disabled in the generic map parameters, `<prefix>.3Dscene`. */
    void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
    /** Centres of occupied voxels; valid until the map changes. Null for a map with an origin of
     * its own: floats lack the digits for its places in the world. */
    [[nodiscard]] const mrpt::maps::CSimplePointsMap* getAsSimplePointsMap() const override;
    /** The box around all occupied voxels [m]; all zero if there are none. (Overrides since MRPT
     * 2.11.3, which made it virtual.) */
    [[nodiscard]] mrpt::math::TBoundingBoxf boundingBox() const;

    /** Pairs points of another map with the centres of occupied voxels, as CPointsMap does (which
     * pairs none if the boxes around all points of either map are apart, however little).
     *  \throws std::runtime_error if the other map is neither a CPointsMap nor can be seen as one
     */
    void determineMatching3D(const mrpt::maps::CMetricMap* other,
                             const mrpt::poses::CPose3D& otherPose,
                             mrpt::tfest::TMatchingPairList& correspondences,
                             const mrpt::maps::TMatchingParams& params,
                             mrpt::maps::TMatchingExtraResults& results) const override;
    /** Like determineMatching3D(), but seen from above, with those voxels alone whose heights the
     * other map's points have: a planar scan is matched with what a planar scanner of its height
     * would see, not with the floor. */
    void determineMatching2D(const mrpt::maps::CMetricMap* other,
                             const mrpt::poses::CPose2D& otherPose,
                             mrpt::tfest::TMatchingPairList& correspondences,
                             const mrpt::maps::TMatchingParams& params,
                             mrpt::maps::TMatchingExtraResults& results) const override;
    /** Share of the other map's points that have the centre of an occupied voxel within
     *  `params.maxDistForCorr`, in [0,1]; 0 if either map is empty. `maxMahaDistForCorr` is for
     * maps whose elements have covariances, which voxels have not. \throws std::runtime_error as
     * determineMatching3D() */
    [[nodiscard]] float compute3DMatchingRatio(
        const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
        const mrpt::maps::TMatchingRatioParams& params) const override;
    /** Not for this map. \throws std::logic_error always: a point on the floor plan has no height,
     * without which it is near a voxel of the floor wherever it is; use determineMatching2D() */
    [[nodiscard]] float squareDistanceToClosestCorrespondence(float x0, float y0) const override;
    /** @} */

    MAP_DEFINITION_START(CVoxelandMap)
    std::string load;                            //!< map file to begin with; empty: none
    std::shared_ptr<const MapperConfig> config;  //!< null: all defaults
    LikelihoodOptions likelihoodOpts;  //!< section `<prefix>_voxelandMap_00_likelihoodOpts`
    MAP_DEFINITION_END(CVoxelandMap)

 private:
    void internal_clear() override;
    /** Takes CObservation3DRangeScan and CObservationInstances, ignores all else. `robotPose` is
     * that of the robot when the observation was made.
     *  \throws InputError for a frame that cannot be mapped: this one, or one that waited */
    bool internal_insertObservation(
        const mrpt::obs::CObservation& observation,
        const std::optional<const mrpt::poses::CPose3D>& robotPose = std::nullopt) override;
    /** See LikelihoodOptions. */
    double internal_computeObservationLikelihood(
        const mrpt::obs::CObservation& observation,
        const mrpt::poses::CPose3D& takenFrom) const override;
    /** What observedPoints() knows. */
    bool internal_canComputeObservationLikelihood(
        const mrpt::obs::CObservation& observation) const override;
    /** Whether to map a scan; the first one with a depth image decides on the camera if the
     * configuration names none. */
    bool isOfTheCamera(const mrpt::obs::CObservation3DRangeScan& scan);
    void mapCompleteFrames();
    void startAssembler();

    std::string m_configText;
    std::optional<std::string> m_camera;  //!< sensor label (maybe empty) of the first scan
    SharedVoxelMap m_map;
    MappingCounts m_counts;
    MappedFrames m_frames;
    FrameAssembler m_assembler;
    std::optional<SemanticMapper> m_mapper;
};
}  // namespace voxeland
