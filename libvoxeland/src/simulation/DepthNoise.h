// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/SceneRenderer.h"

#include <cstdint>
#include <vector>

namespace voxeland::simulation
{
/** Makes of an exact view what a structured-light depth camera would measure.
 *  \return row-major depth [mm]; 0 where nothing is measured */
[[nodiscard]] std::vector<uint16_t> measureDepth(const RenderedView& view,
                                                 const RenderCamera& camera,
                                                 const DepthNoiseOptions& options, Random& random);

/** Standard deviation of the noise along the ray [m] at depth z [m]. */
[[nodiscard]] float axialSigma(const DepthNoiseOptions& options, float z);
}  // namespace voxeland::simulation
