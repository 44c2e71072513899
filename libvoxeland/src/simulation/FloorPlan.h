// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "FurnitureGroup.h"

#include <optional>
#include <vector>

namespace voxeland::simulation
{
/** Which parts of a room's floor are taken. */
class FloorPlan
{
 public:
    explicit FloorPlan(const Room& room) : m_room(room) {}

    /** Keeps a rectangle free, e.g. in front of a door. */
    void reserve(const Room& rectangle) { m_taken.push_back(rectangle); }

    /** Finds a place for a group at random and takes it.
     *  \return the pose to build the group at, or none if there is no room left */
    std::optional<mrpt::poses::CPose3D> place(const FurnitureGroup& group, Random& random);

 private:
    [[nodiscard]] bool isFree(const Room& rectangle) const;

    Room m_room;
    std::vector<Room> m_taken;
};
}  // namespace voxeland::simulation
