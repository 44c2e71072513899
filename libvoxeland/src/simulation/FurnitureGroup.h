// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Furniture.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <functional>

namespace voxeland::simulation
{
/** Furniture that belongs together, e.g. a table with its chairs, not yet in its place. */
struct FurnitureGroup
{
    float width = 0;     //!< floor it needs along y, symmetric [m]
    float depth = 0;     //!< floor it needs along x [m]
    bool atWall = true;  //!< true: x counts from a wall, into the room; false: from its middle
    /** Adds the pieces to a scene; the pose is the origin of the frame x and y refer to. */
    std::function<void(Scene&, const mrpt::poses::CPose3D&, Random&)> build;
};

/** \name The groups there are
 *  @{ */
[[nodiscard]] FurnitureGroup sofaGroup(const SceneOptions& options, Random& random);
[[nodiscard]] FurnitureGroup tvGroup(Random& random);
[[nodiscard]] FurnitureGroup bedGroup(Random& random);
[[nodiscard]] FurnitureGroup diningGroup(const SceneOptions& options, Random& random);
[[nodiscard]] FurnitureGroup kitchenGroup(const SceneOptions& options);
[[nodiscard]] FurnitureGroup deskGroup(Random& random);
[[nodiscard]] FurnitureGroup toiletGroup();
[[nodiscard]] FurnitureGroup chairRow(Random& random);
[[nodiscard]] FurnitureGroup bookshelfGroup();
[[nodiscard]] FurnitureGroup backpackGroup();
/** One of the objects that are not in the detector's vocabulary. */
[[nodiscard]] FurnitureGroup unknownGroup(Random& random);
/** @} */
}  // namespace voxeland::simulation
