// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

namespace voxeland
{
/** The stages whose time is measured, in the order they run. */
enum class Stage
{
    detection,  //!< predictions, where the converter makes them, by a network
    decode,     //!< reading and decoding of images
    voxelize,   //!< unprojecting and grouping pixels by voxel
    opinions,   //!< masks to opinions, clustering included
    rays,       //!< ray casting
    association,
    integration,  //!< evidence and occupancy into the map
    refinement,
    count_
};

inline constexpr size_t STAGES = static_cast<size_t>(Stage::count_);
inline constexpr std::array<const char*, STAGES> STAGE_NAMES = {
    "detection", "decode",      "voxelize",    "opinions",
    "rays",      "association", "integration", "refinement"};

/** CPU time of one frame's stages [s]; of detection, which may use several cores or a graphics
 * card, the elapsed time. */
using StageTimes = std::array<double, STAGES>;

/** Adds the CPU time of the calling thread while it lives to one stage. */
class StageTimer
{
 public:
    StageTimer(StageTimes& times, Stage stage);
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

 private:
    double& m_time;
    double m_start;
};
}  // namespace voxeland
