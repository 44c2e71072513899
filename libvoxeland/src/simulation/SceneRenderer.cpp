// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/SceneRenderer.h"

#include "RayIntersection.h"

#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
RenderCamera::RenderCamera(const CameraOptions& o)
    : width(o.width),
      height(o.height),
      focal(o.focalLength * static_cast<float>(o.width) / 640.0F),
      cx(static_cast<float>(o.width - 1) / 2),
      cy(static_cast<float>(o.height - 1) / 2)
{
}

std::optional<RenderCamera::Pixel> RenderCamera::project(const CameraFrame& frame,
                                                         const Vector3& point) const
{
    constexpr float NEAR = 0.05F;
    const Vector3 p = point - frame.origin;
    const float z = dot(p, frame.forward);
    if (z < NEAR) return std::nullopt;
    const float u = std::round(cx - focal * dot(p, frame.left) / z),
                v = std::round(cy - focal * dot(p, frame.up) / z);
    if (u < 0 || v < 0 || u >= static_cast<float>(width) || v >= static_cast<float>(height))
        return std::nullopt;
    return Pixel{static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u), z};
}

CameraFrame::CameraFrame(const mrpt::math::TPose3D& pose)
    : origin(static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.z))
{
    const mrpt::poses::CPose3D frame(pose);
    forward = frame.rotateVector({1, 0, 0}).cast<float>();
    left = frame.rotateVector({0, 1, 0}).cast<float>();
    up = frame.rotateVector({0, 0, 1}).cast<float>();
}

SceneRenderer::SceneRenderer(const Scene& scene, const RenderCamera& camera)
    : m_scene(scene), m_camera(camera)
{
    for (const auto& room : scene.rooms())
        m_lamps.emplace_back((room.minX + room.maxX) / 2, (room.minY + room.maxY) / 2, 2.3F);
}

/** Rectangle of the image around the solid; empty if it is behind the camera or out of view. */
SceneRenderer::Rectangle SceneRenderer::cover(const Solid& solid, const CameraFrame& frame) const
{
    constexpr float NEAR = 0.05F;
    const Rectangle all{0, 0, m_camera.width, m_camera.height};
    float left = 1e9F, right = -1e9F, top = 1e9F, bottom = -1e9F;
    int behind = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3& h = solid.halfSize();
        const Vector3 local{(corner & 1) != 0 ? h.x : -h.x, (corner & 2) != 0 ? h.y : -h.y,
                            (corner & 4) != 0 ? h.z : -h.z};
        const Vector3 p = solid.pointToWorld(local) - frame.origin;
        const float z = dot(p, frame.forward);
        if (z < NEAR) {
            ++behind;
            continue;
        }
        const float u = m_camera.cx - m_camera.focal * dot(p, frame.left) / z,
                    v = m_camera.cy - m_camera.focal * dot(p, frame.up) / z;
        left = std::min(left, u);
        right = std::max(right, u);
        top = std::min(top, v);
        bottom = std::max(bottom, v);
    }
    if (behind == 8) return {0, 0, 0, 0};
    if (behind > 0) return all;
    const auto within = [](float x, int size) {
        return static_cast<int>(std::clamp(x, 0.0F, static_cast<float>(size)));
    };
    return {within(left, all.right), within(top, all.bottom), within(right + 2, all.right),
            within(bottom + 2, all.bottom)};
}

template <Solid::Shape SHAPE>
void SceneRenderer::draw(PartIndex part, const CameraFrame& frame, const Rectangle& area,
                         std::vector<float>& depth, std::vector<PartIndex>& parts) const
{
    const Solid& solid = m_scene.parts()[part].solid;
    const Vector3 origin = solid.pointToLocal(frame.origin), half = solid.halfSize();
    const Vector3 forward = solid.directionToLocal(frame.forward),
                  right = solid.directionToLocal(frame.left) * (-1 / m_camera.focal),
                  down = solid.directionToLocal(frame.up) * (-1 / m_camera.focal);
    const float cx = m_camera.cx;  // copies: for all the compiler knows the stores below
    const int end = area.right;    // might change the originals
    for (int v = area.top; v < area.bottom; ++v) {
        const Vector3 row = forward + down * (static_cast<float>(v) - m_camera.cy);
        const size_t first = static_cast<size_t>(v) * static_cast<size_t>(m_camera.width);
        float* const depths = &depth[first];
        PartIndex* const owners = &parts[first];
        for (int u = area.left; u < end; ++u) {
            const float x = static_cast<float>(u) - cx;
            const Vector3 direction{row.x + right.x * x, row.y + right.y * x, row.z + right.z * x};
            const Slab inside = intersectSolid<SHAPE>(origin, direction, half);
            const float depthSoFar = depths[u];
            const PartIndex ownerSoFar = owners[u];
            const bool closer = entersBefore(inside, depthSoFar);
            depths[u] = closer ? inside.enter : depthSoFar;
            owners[u] = closer ? part : ownerSoFar;
        }
    }
}

/** Brightness of a surface: the lamp of its room, and light from everywhere, more from above. */
float SceneRenderer::light(const Vector3& point, const Vector3& normal) const
{
    float lamp = 0;
    float nearest = 1e9F;
    for (const auto& position : m_lamps) {
        const Vector3 to = position - point;
        const float distance = to.norm();
        if (distance >= nearest) continue;
        nearest = distance;
        lamp = std::max(0.0F, dot(to, normal) / distance) / (1 + 0.05F * distance * distance);
    }
    return 0.6F + 0.06F * normal.z + 0.05F * normal.x + 0.36F * lamp;
}

RenderedView SceneRenderer::render(const mrpt::math::TPose3D& pose) const
{
    const CameraFrame frame(pose);
    const size_t pixels = m_camera.pixels();
    RenderedView view;
    view.depth.assign(pixels, NO_HIT);
    std::vector<PartIndex> parts(pixels, NOTHING);
    for (size_t i = 0; i < m_scene.parts().size(); ++i) {
        const auto part = static_cast<PartIndex>(i);
        const Solid& solid = m_scene.parts()[i].solid;
        const Rectangle area = cover(solid, frame);
        switch (solid.shape()) {
            case Solid::Shape::Box:
                draw<Solid::Shape::Box>(part, frame, area, view.depth, parts);
                break;
            case Solid::Shape::Cylinder:
                draw<Solid::Shape::Cylinder>(part, frame, area, view.depth, parts);
                break;
            case Solid::Shape::Ellipsoid:
                draw<Solid::Shape::Ellipsoid>(part, frame, area, view.depth, parts);
                break;
        }
    }

    view.objects.assign(pixels, STRUCTURE);
    view.cosines.assign(pixels, 0);
    view.bgr.assign(3 * pixels, 0);
    size_t i = 0;
    for (int v = 0; v < m_camera.height; ++v)
        for (int u = 0; u < m_camera.width; ++u, ++i) {
            if (parts[i] == NOTHING) {
                view.depth[i] = 0;
                continue;
            }
            const auto& part = m_scene.parts()[parts[i]];
            const Vector3 ray =
                frame.forward -
                frame.left * ((static_cast<float>(u) - m_camera.cx) / m_camera.focal) -
                frame.up * ((static_cast<float>(v) - m_camera.cy) / m_camera.focal);
            const Vector3 point = frame.origin + ray * view.depth[i];
            const Vector3 local = part.solid.pointToLocal(point),
                          normal = part.solid.normalAt(local);
            view.objects[i] = part.object;
            view.cosines[i] = -dot(normal, ray) / ray.norm();
            const Colour colour = surfaceColour(part.solid.appearance(), local.x, local.y, local.z);
            const float brightness = 255 * light(point, normal);
            const auto byte = [&](float c) {
                return static_cast<uint8_t>(std::clamp(c * brightness, 0.0F, 255.0F));
            };
            view.bgr[3 * i] = byte(colour.b);
            view.bgr[3 * i + 1] = byte(colour.g);
            view.bgr[3 * i + 2] = byte(colour.r);
        }
    return view;
}
}  // namespace voxeland::simulation
