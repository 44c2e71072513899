// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Solid.h"

#include "RayIntersection.h"

#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
namespace
{
constexpr float PI = 3.14159265F;

/** Numbers from -h to h, at most spacing apart, at the middle of equal steps. */
std::vector<float> steps(float h, float spacing)
{
    const int n = std::max(1, static_cast<int>(std::ceil(2 * h / spacing)));
    std::vector<float> result;
    for (int i = 0; i < n; ++i)
        result.push_back(h * ((2.0F * static_cast<float>(i) + 1) / static_cast<float>(n) - 1));
    return result;
}

/** Equal steps around a full turn [rad] such that points at radius r are at most spacing apart. */
std::vector<float> turn(float r, float spacing)
{
    return steps(PI, std::min(2 * PI, spacing / r));
}
}  // namespace

void Bounds::include(const Bounds& other)
{
    min = {std::min(min.x, other.min.x), std::min(min.y, other.min.y),
           std::min(min.z, other.min.z)};
    max = {std::max(max.x, other.max.x), std::max(max.y, other.max.y),
           std::max(max.z, other.max.z)};
}

bool Bounds::near(const Bounds& o, float gap) const
{
    return min.x < o.max.x + gap && o.min.x < max.x + gap && min.y < o.max.y + gap &&
           o.min.y < max.y + gap && min.z < o.max.z + gap && o.min.z < max.z + gap;
}

Solid::Solid(Shape shape, const mrpt::math::TPose3D& pose, const Vector3& halfSize,
             const Appearance& appearance)
    : m_shape(shape),
      m_center(static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.z)),
      m_halfSize(halfSize),
      m_appearance(appearance)
{
    const mrpt::poses::CPose3D frame(pose);
    m_axes = {frame.rotateVector({1, 0, 0}).cast<float>(),
              frame.rotateVector({0, 1, 0}).cast<float>(),
              frame.rotateVector({0, 0, 1}).cast<float>()};
    const Vector3 &a = m_axes[0], &b = m_axes[1], &c = m_axes[2], &h = m_halfSize;
    const Vector3 reach{std::abs(a.x) * h.x + std::abs(b.x) * h.y + std::abs(c.x) * h.z,
                        std::abs(a.y) * h.x + std::abs(b.y) * h.y + std::abs(c.y) * h.z,
                        std::abs(a.z) * h.x + std::abs(b.z) * h.y + std::abs(c.z) * h.z};
    m_bounds = {m_center - reach, m_center + reach};
}

std::optional<float> Solid::intersect(const Vector3& origin, const Vector3& direction) const
{
    const Vector3 o = pointToLocal(origin), d = directionToLocal(direction);
    Slab inside{NO_HIT, NO_HIT};
    switch (m_shape) {
        case Shape::Box:
            inside = intersectSolid<Shape::Box>(o, d, m_halfSize);
            break;
        case Shape::Cylinder:
            inside = intersectSolid<Shape::Cylinder>(o, d, m_halfSize);
            break;
        case Shape::Ellipsoid:
            inside = intersectSolid<Shape::Ellipsoid>(o, d, m_halfSize);
            break;
    }
    if (!entersBefore(inside, NO_HIT)) return std::nullopt;
    return inside.enter;
}

Vector3 Solid::normalAt(const Vector3& p) const
{
    const Vector3& h = m_halfSize;
    const float x = p.x / h.x, y = p.y / h.y, z = p.z / h.z;
    Vector3 normal{0, 0, 0};
    if (m_shape == Shape::Ellipsoid) {
        normal = {x / h.x, y / h.y, z / h.z};
    } else if (m_shape == Shape::Cylinder) {
        const bool onCap = std::abs(z) > std::sqrt(x * x + y * y);
        normal = onCap ? Vector3{0, 0, z} : Vector3{x / h.x, y / h.y, 0};
    } else {
        // The face is the one the point is nearest to, in metres.
        const float dx = h.x - std::abs(p.x), dy = h.y - std::abs(p.y), dz = h.z - std::abs(p.z);
        if (dx <= dy && dx <= dz)
            normal.x = x;
        else if (dy <= dz)
            normal.y = y;
        else
            normal.z = z;
    }
    const float length = normal.norm();
    return directionToWorld(length > 0 ? normal / length : Vector3{0, 0, 1});
}

bool Solid::contains(const Vector3& world, float margin) const
{
    const Vector3 p = pointToLocal(world);
    const Vector3 h = m_halfSize - Vector3{margin, margin, margin};
    if (h.x <= 0 || h.y <= 0 || h.z <= 0) return false;
    const float x = p.x / h.x, y = p.y / h.y, z = p.z / h.z;
    switch (m_shape) {
        case Shape::Box:
            return std::abs(x) < 1 && std::abs(y) < 1 && std::abs(z) < 1;
        case Shape::Cylinder:
            return x * x + y * y < 1 && std::abs(z) < 1;
        case Shape::Ellipsoid:
            return x * x + y * y + z * z < 1;
    }
    return false;
}

std::vector<SurfacePoint> Solid::sampleSurface(float spacing) const
{
    const Vector3& h = m_halfSize;
    std::vector<SurfacePoint> points;
    const auto add = [&](const Vector3& p) { points.push_back({pointToWorld(p), normalAt(p)}); };

    if (m_shape == Shape::Box) {
        const auto xs = steps(h.x, spacing), ys = steps(h.y, spacing), zs = steps(h.z, spacing);
        for (const float side : {-1.0F, 1.0F}) {
            for (const float y : ys)
                for (const float z : zs) add({side * h.x, y, z});
            for (const float x : xs)
                for (const float z : zs) add({x, side * h.y, z});
            for (const float x : xs)
                for (const float y : ys) add({x, y, side * h.z});
        }
    } else if (m_shape == Shape::Cylinder) {
        const float r = std::max(h.x, h.y);
        for (const float angle : turn(r, spacing))
            for (const float z : steps(h.z, spacing))
                add({h.x * std::cos(angle), h.y * std::sin(angle), z});
        const int rings = std::max(1, static_cast<int>(std::ceil(r / spacing)));
        for (int ring = 0; ring < rings; ++ring) {
            const float share = (static_cast<float>(ring) + 0.5F) / static_cast<float>(rings);
            for (const float angle : turn(share * r, spacing))
                for (const float side : {-1.0F, 1.0F})
                    add({share * h.x * std::cos(angle), share * h.y * std::sin(angle), side * h.z});
        }
    } else {
        const float r = std::max({h.x, h.y, h.z});
        for (const float latitude : steps(PI / 2, spacing / r))
            for (const float angle : turn(std::max(r * std::cos(latitude), 1e-3F), spacing))
                add({h.x * std::cos(latitude) * std::cos(angle),
                     h.y * std::cos(latitude) * std::sin(angle), h.z * std::sin(latitude)});
    }
    return points;
}
}  // namespace voxeland::simulation
