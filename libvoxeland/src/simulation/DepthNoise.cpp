// SPDX-License-Identifier: BSD-3-Clause
#include "DepthNoise.h"

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
namespace
{
uint16_t toMillimetres(float z)
{
    return static_cast<uint16_t>(std::clamp(std::lround(z * 1000), 0L, 65535L));
}

/** The nearest depth whose disparity is a multiple of the step.
 *  \param product focal length times baseline [m pixels] */
float quantized(float z, float product, float step)
{
    const float disparity = std::max(1.0F, std::round(product / z / step));
    return product / (disparity * step);
}
}  // namespace

float axialSigma(const DepthNoiseOptions& o, float z)
{
    const float d = z - o.axialOffset;
    return o.axialConstant + o.axialFactor * d * d;
}

std::vector<uint16_t> measureDepth(const RenderedView& view, const RenderCamera& camera,
                                   const DepthNoiseOptions& o, Random& random)
{
    constexpr float EDGE = 0.05F;  // a jump of more than this share of the depth is an edge
    std::vector<uint16_t> result(view.depth.size(), 0);
    if (!o.enabled) {
        std::transform(view.depth.begin(), view.depth.end(), result.begin(), toMillimetres);
        return result;
    }
    const float lateral = o.lateralSigma * camera.scale();
    const float product = camera.focal * o.baseline, step = o.disparityStep * camera.scale();
    const auto pixel = [&](int u, int v) {
        u = std::clamp(u, 0, camera.width - 1);
        v = std::clamp(v, 0, camera.height - 1);
        return static_cast<size_t>(v) * static_cast<size_t>(camera.width) + static_cast<size_t>(u);
    };
    for (int v = 0; v < camera.height; ++v)
        for (int u = 0; u < camera.width; ++u) {
            const size_t here = pixel(u, v);
            const int du = static_cast<int>(std::lround(random.normal(lateral))),
                      dv = static_cast<int>(std::lround(random.normal(lateral)));
            const float z = view.depth[pixel(u + du, v + dv)];
            const float lost = static_cast<float>(random.uniform());
            if (z < o.minRange || z > o.maxRange || view.cosines[here] < o.grazingDropout) continue;
            const bool edge = std::abs(view.depth[pixel(u + 1, v)] - z) > EDGE * z ||
                              std::abs(view.depth[pixel(u - 1, v)] - z) > EDGE * z ||
                              std::abs(view.depth[pixel(u, v + 1)] - z) > EDGE * z ||
                              std::abs(view.depth[pixel(u, v - 1)] - z) > EDGE * z;
            if (lost < (edge ? o.edgeDropout : o.randomDropout)) continue;
            float measured = z + random.normal(axialSigma(o, z));
            if (step > 0) measured = quantized(measured, product, step);
            if (measured <= o.maxRange) result[here] = toMillimetres(measured);
        }
    return result;
}
}  // namespace voxeland::simulation
