// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxeland::simulation
{
/** Returned where a ray misses. */
constexpr float NO_HIT = std::numeric_limits<float>::infinity();

/** Interval of t in which a ray is between the planes -h and h of one axis. */
struct Slab
{
    float enter, leave;
};

inline Slab intersectSlab(float o, float d, float h)
{
    const float inverse = 1 / (std::abs(d) < 1e-12F ? 1e-12F : d);  // 0 * infinity is no number
    const float a = (-h - o) * inverse, b = (h - o) * inverse;
    return {std::min(a, b), std::max(a, b)};
}

/** Interval of t in which a ray is within the unit circle or sphere: a t^2 + 2 b t + c <= 0.
 *  Empty (enter > leave) if it never is. */
inline Slab intersectQuadric(float a, float b, float c)
{
    const float safe = std::max(a, 1e-12F);  // a ray along the axis is always in or always out
    const float discriminant = b * b - safe * c;
    const float root = std::sqrt(std::max(discriminant, 0.0F));
    return {discriminant >= 0 ? (-b - root) / safe : NO_HIT,
            discriminant >= 0 ? (-b + root) / safe : -NO_HIT};
}

/** Interval of t in which a ray is inside a solid, all in the solid's frame; empty if it misses.
 *  Without branches, so that loops over a row of pixels are vectorized. */
template <Solid::Shape SHAPE>
inline Slab intersectSolid(const Vector3& o, const Vector3& d, const Vector3& h)
{
    if constexpr (SHAPE == Solid::Shape::Box) {
        const Slab x = intersectSlab(o.x, d.x, h.x), y = intersectSlab(o.y, d.y, h.y),
                   z = intersectSlab(o.z, d.z, h.z);
        return {std::max(std::max(x.enter, y.enter), z.enter),
                std::min(std::min(x.leave, y.leave), z.leave)};
    }
    const float ox = o.x / h.x, oy = o.y / h.y, dx = d.x / h.x, dy = d.y / h.y;
    if constexpr (SHAPE == Solid::Shape::Cylinder) {
        const Slab side =
            intersectQuadric(dx * dx + dy * dy, ox * dx + oy * dy, ox * ox + oy * oy - 1);
        const Slab z = intersectSlab(o.z, d.z, h.z);
        return {std::max(side.enter, z.enter), std::min(side.leave, z.leave)};
    }
    const float oz = o.z / h.z, dz = d.z / h.z;
    return intersectQuadric(dx * dx + dy * dy + dz * dz, ox * dx + oy * dy + oz * dz,
                            ox * ox + oy * oy + oz * oz - 1);
}

/** true where a ray enters a solid from outside, nearer than `limit`. */
inline bool entersBefore(const Slab& inside, float limit)
{
    return (static_cast<int>(inside.enter <= inside.leave) & static_cast<int>(inside.enter > 0) &
            static_cast<int>(inside.enter < limit)) != 0;
}
}  // namespace voxeland::simulation
