// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/Scene.h"
#include "voxeland/simulation/SimulationOptions.h"

namespace voxeland::simulation
{
/** Builds an apartment of one to three furnished rooms, different for each seed. Rooms stand in a
 *  row along x, joined by door openings: a studio; a living room and a bedroom; a living room, a
 *  kitchen and a bedroom.
 *  \throws std::runtime_error if the furniture does not fit (it always should) */
[[nodiscard]] Scene makeApartment(const SceneOptions& options, Random random);
}  // namespace voxeland::simulation
