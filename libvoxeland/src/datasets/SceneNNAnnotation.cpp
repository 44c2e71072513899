// SPDX-License-Identifier: BSD-3-Clause
#include "SceneNNAnnotation.h"

#include "AnnotatedObjects.h"
#include "observations/PixelDirections.h"
#include "voxeland/datasets/GroundTruth.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxeland
{
namespace
{
constexpr double CUBE = 0.025;  // [m]

/** Number of a cube; 21 bits for each coordinate reach 26 km. */
uint64_t keyOf(double x, double y, double z)
{
    const auto bits = [](double v) {
        return static_cast<uint64_t>(static_cast<int64_t>(v)) & 0x1FFFFF;
    };
    return bits(x) << 42 | bits(y) << 21 | bits(z);
}
}  // namespace

SceneNNAnnotation::SceneNNAnnotation(const std::string& sceneFolder)
{
    const GroundTruth truth = readSceneNNGroundTruth(sceneFolder);
    std::vector<std::pair<uint64_t, uint32_t>> vertices;  // cube, object
    for (size_t i = 0; i < truth.points.size(); ++i) {
        const auto cube = [](double v) { return std::floor(v / CUBE); };
        const auto& p = truth.points[i];
        vertices.emplace_back(keyOf(cube(p.x), cube(p.y), cube(p.z)), truth.instance[i]);
        if (truth.instance[i] != 0)
            m_categories[truth.instance[i]] = truth.names[truth.category[i]];
    }
    std::sort(vertices.begin(), vertices.end());
    std::unordered_map<uint64_t, std::ptrdiff_t> most;
    for (auto first = vertices.begin(); first != vertices.end();) {
        const auto last = std::upper_bound(first, vertices.end(), *first);
        if (last - first > most[first->first]) {
            most[first->first] = last - first;
            m_objects[first->first] = first->second;
        }
        first = last;
    }
}

uint32_t SceneNNAnnotation::objectAt(double x, double y, double z) const
{
    const double cx = std::floor(x / CUBE), cy = std::floor(y / CUBE), cz = std::floor(z / CUBE);
    const auto own = m_objects.find(keyOf(cx, cy, cz));
    if (own != m_objects.end()) return own->second;
    uint32_t object = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dz = -1; dz <= 1; ++dz) {
                const auto at = m_objects.find(keyOf(cx + dx, cy + dy, cz + dz));
                if (at == m_objects.end()) continue;
                const double distance =
                    std::hypot((cx + dx + 0.5) * CUBE - x, (cy + dy + 0.5) * CUBE - y,
                               (cz + dz + 0.5) * CUBE - z);
                if (distance >= nearest) continue;
                nearest = distance;
                object = at->second;
            }
    return object;
}

CObservationInstances::Ptr SceneNNAnnotation::instancesOf(const RgbdRecord& record) const
{
    const auto& scan = *record.scan;
    const size_t columns = scan.cameraParams.ncols, rows = scan.cameraParams.nrows;
    const mrpt::poses::CPose3D pose(*record.robotPose);
    PixelDirections directions(scan);
    std::vector<uint32_t> objects(columns * rows, 0);
    for (size_t row = 0; row < rows; ++row) {
        directions.select(row);
        for (size_t c = 0; c < columns; ++c) {
            const double depth =
                static_cast<double>(scan.rangeImage(static_cast<int>(row), static_cast<int>(c))) *
                static_cast<double>(scan.rangeUnits);
            if (depth == 0) continue;
            const auto p = pose.composePoint({depth * static_cast<double>(directions.x()[c]),
                                              depth * static_cast<double>(directions.y()[c]),
                                              depth * static_cast<double>(directions.z()[c])});
            objects[row * columns + c] = objectAt(p.x, p.y, p.z);
        }
    }
    return predictionsOf(objects, static_cast<int>(columns), static_cast<int>(rows),
                         [&](uint32_t object) { return m_categories.at(object); });
}
}  // namespace voxeland
