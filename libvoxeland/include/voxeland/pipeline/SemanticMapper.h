// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/MappingCounts.h"
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/pipeline/Overlaps.h"
#include "voxeland/pipeline/PreparedFrame.h"

#include <memory>
#include <optional>

namespace voxeland
{
class MappingTrace;

/** The paper's loop: turns frames into a semantic voxel map. */
class SemanticMapper
{
 public:
    explicit SemanticMapper(MapperConfig config) : m_config(std::move(config)) {}

    [[nodiscard]] const MapperConfig& config() const { return m_config; }

    /** Lets integrate() tell why it decides as it does. \param trace null: no more */
    void setTrace(std::shared_ptr<MappingTrace> trace) { m_trace = std::move(trace); }

    /** Replaces the frame's predictions by the converter's own, where it makes any. Comes before
     * prepare(), in the order of the frames. \throws InputError for unusable frames */
    void predict(RgbdFrame& frame) const;

    /** The part of the work that needs no map. Thread safe.
     *  \param frame its pose is in the map's frame
     *  \throws InputError for unusable frames, UnusableFrame for those that saw what cannot be
     * stored */
    [[nodiscard]] PreparedFrame prepare(const RgbdFrame& frame) const;

    /** Adds a prepared frame to a map. Frames must come in order.
     *  \return the frame's stage times, those of prepare() included */
    StageTimes integrate(PreparedFrame frame, SemanticVoxelMap& map, MappingCounts& counts);
    /** Says that somebody else has changed the map: the next refinement looks at all of it. */
    void mapWasEdited() { m_refinedAt.reset(); }

 private:
    MapperConfig m_config;
    OverlapFinder m_overlaps;
    std::shared_ptr<MappingTrace> m_trace;
    std::optional<uint32_t> m_refinedAt;  //!< frames that had been mapped then
};
}  // namespace voxeland
