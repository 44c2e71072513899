// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Appearance.h"
#include "voxeland/simulation/Vector3.h"

#include <mrpt/math/TPose3D.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace voxeland::simulation
{
/** A point of a surface with its outward unit normal. */
struct SurfacePoint
{
    Vector3 position;  //!< world [m]
    Vector3 normal;    //!< world, unit length
};

/** Box with sides along the world's axes. */
struct alignas(float) Bounds
{
    Vector3 min{1e9F, 1e9F, 1e9F};
    Vector3 max{-1e9F, -1e9F, -1e9F};

    /** Grows to hold another box. */
    void include(const Bounds& other);
    /** true if the two boxes come closer than gap [m], or overlap. */
    [[nodiscard]] bool near(const Bounds& other, float gap) const;
    [[nodiscard]] Vector3 center() const { return (min + max) * 0.5F; }
    [[nodiscard]] Vector3 size() const { return max - min; }
};

/** A convex body that rays can be intersected with exactly: what scenes are made of. */
class Solid
{
 public:
    /** Forms a solid can have; all are centred on, and aligned with, the solid's own frame. */
    enum class Shape : uint8_t
    {
        Box,
        Cylinder,  //!< axis along z, elliptic if the half sizes in x and y differ
        Ellipsoid
    };

    /** \param pose the solid's frame in the world
     *  \param halfSize half of its extent along its own axes [m], all positive */
    Solid(Shape shape, const mrpt::math::TPose3D& pose, const Vector3& halfSize,
          const Appearance& appearance);

    [[nodiscard]] Shape shape() const { return m_shape; }
    [[nodiscard]] const Vector3& halfSize() const { return m_halfSize; }
    [[nodiscard]] const Appearance& appearance() const { return m_appearance; }
    void setAppearance(const Appearance& appearance) { m_appearance = appearance; }
    /** Axis-aligned box around it, in the world. */
    [[nodiscard]] const Bounds& bounds() const { return m_bounds; }

    [[nodiscard]] Vector3 pointToLocal(const Vector3& world) const
    {
        return directionToLocal(world - m_center);
    }
    [[nodiscard]] Vector3 directionToLocal(const Vector3& world) const
    {
        return {dot(world, m_axes[0]), dot(world, m_axes[1]), dot(world, m_axes[2])};
    }
    [[nodiscard]] Vector3 pointToWorld(const Vector3& local) const
    {
        return m_center + directionToWorld(local);
    }
    [[nodiscard]] Vector3 directionToWorld(const Vector3& local) const
    {
        return m_axes[0] * local.x + m_axes[1] * local.y + m_axes[2] * local.z;
    }

    /** Where a ray enters the solid: the smallest t > 0 with origin + t*direction on its surface,
     *  in units of direction's length. None if it misses, or starts inside. */
    [[nodiscard]] std::optional<float> intersect(const Vector3& origin,
                                                 const Vector3& direction) const;
    /** Outward unit normal, in the world, at a point of the surface given in the solid's frame. */
    [[nodiscard]] Vector3 normalAt(const Vector3& local) const;
    /** true if a point of the world is inside, deeper than margin [m]. */
    [[nodiscard]] bool contains(const Vector3& world, float margin = 0) const;
    /** Points all over its surface, neighbours at most spacing [m] apart. */
    [[nodiscard]] std::vector<SurfacePoint> sampleSurface(float spacing) const;

 private:
    Shape m_shape;
    alignas(float) Vector3 m_center, m_halfSize;
    std::array<Vector3, 3> m_axes;  //!< of the solid's frame, in the world
    Appearance m_appearance;
    Bounds m_bounds;
};
}  // namespace voxeland::simulation
