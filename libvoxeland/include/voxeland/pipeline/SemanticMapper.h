// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/pipeline/MappingCounts.h"
#include "voxeland/pipeline/Overlaps.h"
#include "voxeland/pipeline/PreparedFrame.h"

namespace voxeland
{
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
