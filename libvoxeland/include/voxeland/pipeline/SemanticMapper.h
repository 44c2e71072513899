// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/pipeline/Overlaps.h"
#include "voxeland/pipeline/PreparedFrame.h"

namespace voxeland
{
/** What went into a map. */
struct MappingCounts
{
    uint32_t frames = 0;                    //!< frames integrated
    uint32_t framesWithoutPredictions = 0;  //!< of those, frames mapped without any opinion source
    uint32_t opinions = 0;                  //!< opinions integrated
    uint32_t framesWithoutPose = 0;         //!< frames skipped: no valid pose was known for them
    uint32_t predictionsWithoutFrame = 0;   //!< predictions left out: no frame of their timestamp
};

/** The paper's loop: turns frames into a semantic voxel map. */
class SemanticMapper
{
 public:
    explicit SemanticMapper(MapperConfig config) : m_config(std::move(config)) {}

    [[nodiscard]] const MapperConfig& config() const { return m_config; }

    /** The part of the work that needs no map. Thread safe. \throws InputError for unusable frames
     */
    [[nodiscard]] PreparedFrame prepare(const RgbdFrame& frame) const;

    /** Adds a prepared frame to a map. Frames must come in order.
     *  \return the frame's stage times, those of prepare() included */
    StageTimes integrate(PreparedFrame frame, SemanticVoxelMap& map, MappingCounts& counts);

 private:
    MapperConfig m_config;
    OverlapFinder m_overlaps;
};
}  // namespace voxeland
