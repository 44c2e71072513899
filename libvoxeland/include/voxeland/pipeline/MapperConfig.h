// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/observations/PoseAxes.h"
#include "voxeland/observations/VoxelizedFrame.h"
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/COpinionConverter.h"
#include "voxeland/plugins/DisambiguationOptions.h"
#include "voxeland/plugins/Ini.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace voxeland
{
/** Section [voxeland]: what is read from a rawlog, and how fast. */
struct InputOptions
{
    std::string depth_sensor_label;  //!< sensorLabel of the RGB-D camera; empty: the first one met
    std::string instances_sensor_label;  //!< sensorLabel of the predictions; empty: any
    std::string pose_source =
        "robot_pose";  //!< robot_pose | odometry | actions | simplemap | `tum:FILE`
    PoseAxes pose_axes = PoseAxes::body;  //!< what the poses of rawlog or trajectory are those of
    std::string pose_sensor_label;        //!< sensorLabel of the robot poses; empty: the first met
    double max_pose_gap = 0.25;           //!< longest time to interpolate poses over [s]
    uint32_t prediction_wait = 5;  //!< newer frames to wait for a frame's predictions or pose
    DepthLimits depth;
    uint32_t threads = 0;  //!< threads that read and prepare frames; 0: one a core
    /** The user vouches for images outside of the rawlog's folder, see checkImagePaths(). No key of
     *  the INI: it is said for one run. */
    bool trust_paths = false;
};

/** What is evidence. */
enum class EvidenceRule
{
    novelty,  //!< by what is added: the points that a frame measures in one voxel repeat one
              //!< another, and so do opinions about one side, see CategoryOpinions::independent()
    sum       //!< the paper's: each point and each opinion counts, however often it is repeated
};

/** How opinions become evidence; part of section [map]. */
struct IntegrationOptions
{
    EvidenceRule evidence = EvidenceRule::novelty;
    double unknown_weight = 0.2;  //!< evidence for *unknown* of a pixel that no opinion claims
    /** No voxel of an instance counts as *unknown* in a frame that shows more than this
     * share of the instance, in [0,1], but has no opinion about it; 1 switches that off. Where
     * little is in view, bled voxels must be able to fade. What one false detection made stays,
     * too, until RefinementOptions::min_evidence hides it. */
    double missed_share = 0.5;
    double sharpness =
        2;  //!< exponent of category probabilities before they count as evidence, >= 1
    /** A voxel this far behind a measured surface counts as seen [m]. */
    double visibility_margin = 0.1;
    bool pose_uncertainty = false;  //!< discount evidence of frames whose pose is uncertain
};

/** Section [refinement]: what is done every some frames to mend over- and under-segmentation. Sizes
 * and distances are in voxels. */
struct RefinementOptions
{
    uint32_t every = 30;        //!< frames between two refinements; 0: never
    MergeThresholds merge;      //!< which instances are one object
    bool split = true;          //!< divide instances that fell apart
    bool continuity = true;     //!< merge only what is connected
    double min_evidence = 1.5;  //!< instances with less, the sum of their opinions' confidences,
                                //!< are shown as *unknown* ...
    uint32_t patience = 30;     //!< ... once they were not seen for so many frames
    int dbscan_eps = 2;         //!< voxels up to this far along each axis are neighbours
    uint32_t dbscan_min_points =
        4;  //!< voxels in the neighbourhood (itself included) that make a core
    uint32_t min_part_voxels =
        12;                       //!< least size of a part that becomes an instance of its own ...
    double min_part_share = 0.1;  //!< ... and its least share of the instance's voxels
};

/** Section [calibration]: what the detector's words mean. */
struct CalibrationOptions
{
    std::string words;     //!< file of Calibration::fromCsv(); empty: words mean themselves
    double agreement = 1;  //!< see Calibration::applied()
};

/** Everything an INI says, checked, with the plugins it names. Copies share the
 * plugins, which do not change once configured. */
class MapperConfig
{
 public:
    /** What it is for: to map, or to ask about a map, for which the converter and the association
     * are not started and, if a map names them, need not exist. */
    enum class Purpose
    {
        mapping,
        asking
    };
    using Tell = std::function<void(const std::string& sentence)>;

    /** \param tell gets what was left out of the configuration that a map holds, see OptionList, in
     *  one sentence; null: nobody does
     *  \throws ConfigurationError, or PluginError if a plugin cannot be used; either way with all
     * problems of all sections in one message */
    explicit MapperConfig(const Ini& ini = Ini(), Purpose purpose = Purpose::mapping,
                          const Tell& tell = nullptr);

    /** Names of all sections an INI may have. */
    static const std::vector<std::string>& sections();

    InputOptions input;
    MapOptions map;
    IntegrationOptions integration;
    RefinementOptions refinement;
    /** What maps are given; none: they keep what they have. */
    std::optional<Calibration> calibration;
    DisambiguationOptions disambiguation;
    std::shared_ptr<const COpinionConverter> converter;     //!< for asking maybe null
    std::shared_ptr<const CAssociationPolicy> association;  //!< likewise
    /** Configured, but not started: mapping does without it. */
    std::shared_ptr<CDisambiguator> disambiguator;

    /** All sections with all keys, effective values and comments: an INI that reads back as this.
     */
    [[nodiscard]] const std::string& text() const { return m_text; }
    /** text() without the keys that few users change, as far as they have their defaults. */
    [[nodiscard]] const std::string& commonText() const { return m_commonText; }
    /** text() without what cannot change the resulting map, see OptionList::concernsRun(): stored
     * with the map. */
    [[nodiscard]] const std::string& reproducibleText() const { return m_reproducibleText; }

 private:
    std::string m_text, m_commonText, m_reproducibleText;
};
}  // namespace voxeland
