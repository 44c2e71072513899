// SPDX-License-Identifier: BSD-3-Clause
#include "support/Rooms.h"

namespace voxeland::test
{
namespace
{
/** Adds a copy of a room, `shift` blocks along y, `later` frames later. */
void addRoom(const SemanticVoxelMap& room, int shift, uint32_t later, SemanticVoxelMap& map)
{
    std::map<instance_id_t, instance_id_t> ids = {{UNKNOWN_INSTANCE, UNKNOWN_INSTANCE}};
    for (const auto& [id, instance] : room.instances()) {
        Instance& copy = map.createInstance();
        ids[id] = copy.id;
        copy.categories = instance.categories;
        copy.observations = instance.observations;
        copy.firstFrame = instance.firstFrame + later;
        map.saw(copy.id, instance.lastFrame + later);
    }
    const VoxelCoord by{0, shift, 0};
    for (const uint32_t b : room.blocks().sorted()) {
        const MapBlock& block = room.blocks()[b];
        const VoxelCoord at = room.blocks().coordOf(b) + by;
        MapBlock& copy = map.blocks().at(at);
        for (int cell = 0; cell < BLOCK_CELLS; ++cell)
            copy.setOccupancy(cell, block.occupancy(cell));
        block.forEachSurface([&](int cell, const VoxelEvidence& evidence) {
            for (const auto& e : evidence)
                map.addEvidence(voxelAt(at, cell), ids.at(e.instance), e.alpha);
        });
    }
    for (const instance_id_t id : room.inactive()) map.deactivate(ids.at(id));
}
}  // namespace

SemanticVoxelMap manyRooms(const SemanticVoxelMap& room, int copies, int pitch, uint32_t frames)
{
    SemanticVoxelMap map(room.options());
    for (const std::string& name : room.categories().names()) map.categories().add(name);
    for (int i = 0; i < copies; ++i)
        addRoom(room, i * pitch, static_cast<uint32_t>(i) * frames, map);
    return map;
}
}  // namespace voxeland::test
