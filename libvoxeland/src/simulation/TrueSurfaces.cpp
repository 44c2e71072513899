// SPDX-License-Identifier: BSD-3-Clause
#include "TrueSurfaces.h"

#include "voxeland/base/numbers.h"
#include "voxeland/files/AtomicFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace voxeland::simulation
{
namespace
{
template <typename T>
void appendBytes(std::string& out, T value)
{
    char bytes[sizeof(T)];  // the machines MRPT runs on are little endian
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

int indexOf(const std::vector<std::string>& names, const std::string& name)
{
    return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}
}  // namespace

std::vector<std::string> categoryNames(const Scene& scene)
{
    std::set<std::string> names;
    for (const auto& object : scene.objects()) names.insert(object.category);
    std::vector<std::string> result{"structure"};
    result.insert(result.end(), names.begin(), names.end());
    return result;
}

TrueSurfaces::TrueSurfaces(const Scene& scene, const RenderCamera& camera, float spacing,
                           float maxRange)
    : m_scene(scene), m_camera(camera), m_maxRange(maxRange)
{
    for (size_t id = 0; id <= scene.objects().size(); ++id)
        for (const auto& point : scene.sampleSurface(static_cast<ObjectId>(id), spacing))
            m_points.push_back({point, static_cast<ObjectId>(id), false});
}

void TrueSurfaces::see(const RenderedView& view, const mrpt::math::TPose3D& pose)
{
    const CameraFrame frame(pose);
    for (auto& point : m_points) {
        if (point.seen) continue;
        const Vector3 to = frame.origin - point.surface.position;
        const float distance = to.norm(), facing = dot(to, point.surface.normal);
        if (facing <= 0 || distance > m_maxRange) continue;
        const auto pixel = m_camera.project(frame, point.surface.position);
        if (!pixel || view.objects[pixel->index] != point.object) continue;
        // Within one pixel the depth of a slanted surface changes by this much.
        const float cosine = std::max(0.05F, facing / distance);
        const float tolerance = 0.005F + pixel->depth / m_camera.focal / cosine;
        point.seen = std::abs(view.depth[pixel->index] - pixel->depth) < tolerance;
    }
}

void TrueSurfaces::save(const std::string& folder) const
{
    const auto names = categoryNames(m_scene);
    std::vector<int> categories{0};
    std::vector<int> counts(m_scene.objects().size() + 1, 0);
    for (const auto& object : m_scene.objects())
        categories.push_back(indexOf(names, object.category));

    std::string body;
    int total = 0;
    for (const auto& point : m_points) {
        if (!point.seen) continue;
        ++total;
        ++counts[point.object];
        const Vector3& p = point.surface.position;
        for (const float coordinate : {p.x, p.y, p.z}) appendBytes(body, coordinate);
        appendBytes(body, static_cast<int32_t>(point.object));
        appendBytes(body, static_cast<int32_t>(categories[point.object]));
    }
    writeAtomically(folder + "/ground_truth.ply",
                    "ply\nformat binary_little_endian 1.0\nelement vertex " +
                        std::to_string(total) +
                        "\nproperty float x\nproperty float y\nproperty float z\n"
                        "property int instance\nproperty int category\nend_header\n" +
                        body);

    std::string csv = "index,name\n";
    for (size_t i = 0; i < names.size(); ++i) csv += std::to_string(i) + "," + names[i] + "\n";
    writeAtomically(folder + "/categories.csv", csv);

    csv = "id,category,x,y,z,size_x,size_y,size_z,points\n";
    for (const auto& object : m_scene.objects()) {
        const Vector3 c = object.bounds.center(), s = object.bounds.size();
        csv += std::to_string(object.id) + "," + object.category;
        for (const float value : {c.x, c.y, c.z, s.x, s.y, s.z})
            csv += "," + fixedText(static_cast<double>(value), 6);
        csv += "," + std::to_string(counts[object.id]) + "\n";
    }
    writeAtomically(folder + "/objects.csv", csv);
}
}  // namespace voxeland::simulation
