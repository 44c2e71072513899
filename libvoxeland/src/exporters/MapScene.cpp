// SPDX-License-Identifier: BSD-3-Clause
#include "MapScene.h"

#include "files/GzOutputFile.h"
#include "level/LevelPose.h"
#include "pictures/Colors.h"
#include "voxeland/base/printable.h"
#include "voxeland/level/OrientedBox.h"
#include "voxeland/map/MapQueries.h"

#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CText.h>

#include <type_traits>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
mrpt::img::TColor toMrpt(const Color& c)
{
    return {c.red, c.green, c.blue};
}

/** Sets a light's intensity: a colour in older versions of MRPT, a number in newer ones. */
template <typename Light>
void setIntensity(Light& light, float intensity)
{
    if constexpr (std::is_arithmetic_v<Light>)
        light = intensity;
    else
        light = Light(intensity, intensity, intensity, 1.0F);
}

/** Its box, and its name on top of it. */
void insertInstance(mrpt::opengl::CSetOfObjects& objects, const InstanceSummary& summary,
                    const OrientedBox& box, const Color& color)
{
    const auto frame = mrpt::opengl::CBox::Create(box.size * -0.5, box.size * 0.5, true);
    frame->setPose(poseOf(box.axes, box.center));
    frame->setColor_u8(toMrpt(color));
    objects.insert(frame);
    const std::string name = std::to_string(summary.id) + " " + printable(summary.category());
    const auto text = mrpt::opengl::CText::Create(name);
    text->setLocation(box.center + box.axes.axes()[2] * (box.size.z / 2));
    text->setColor_u8(0, 0, 0);
    text->setName(name);
    objects.insert(text);
}
}  // namespace

std::shared_ptr<mrpt::opengl::COctoMapVoxels> voxelCubes(const SemanticVoxelMap& map)
{
    const auto cubes = mrpt::opengl::COctoMapVoxels::Create();
    cubes->setVisualizationMode(mrpt::opengl::COctoMapVoxels::FIXED);
    cubes->resizeVoxelSets(1);
    cubes->showVoxels(0, true);
    const auto colors = instanceColors(map);
    size_t count = 0;
    map.forEachVoxel([&](const VoxelCoord&, log_odds_t, const VoxelEvidence&) { ++count; });
    cubes->reserveVoxels(0, count);
    const auto edge = static_cast<float>(map.resolution());
    constexpr double INF = std::numeric_limits<double>::infinity();
    TPoint3D least(INF, INF, INF), most(-INF, -INF, -INF);
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const auto center = voxelCenter<TPoint3D>(v, map.resolution());
        cubes->push_back_Voxel(
            0, {mrpt::math::TPoint3Df(center), edge, toMrpt(colors.at(map.winner(evidence)))});
        for (size_t a = 0; a < 3; ++a) {
            least[a] = std::min(least[a], center[a] - map.resolution() / 2);
            most[a] = std::max(most[a], center[a] + map.resolution() / 2);
        }
    });
    if (least.x <= most.x) cubes->setBoundingBox(least, most);
    return cubes;
}

void exportScene(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                 const std::string& file)
{
    const auto objects = mrpt::opengl::CSetOfObjects::Create();
    objects->insert(voxelCubes(map));
    const auto boxes = orientedBoxes(map, frame);
    const auto colors = instanceColors(map);
    for (const InstanceSummary& s : summarizeInstances(map)) {
        OrientedBox box = boxes.at(s.id);
        box.center = map.inMap(box.center);
        insertInstance(*objects, s, box, colors.at(s.id));
    }
    objects->setPose(-poseOf(frame, {0, 0, 0}));
    objects->setLocation(map.origin());

    mrpt::opengl::COpenGLScene scene;
    scene.insert(objects);
    auto& lights = scene.getViewport()->lightParameters();
    setIntensity(lights.ambient, 0.6F);  // the default leaves faces black
    setIntensity(lights.diffuse, 0.4F);
    setIntensity(lights.specular, 0);
    writeAtomically(file, scene);
}

Exporter sceneExporter()
{
    Exporter e{"scene", "FILE.3Dscene",
               "Voxels, boxes and names of instances for MRPT's SceneViewer3D"};
    e.endings = {".3Dscene"};
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        exportScene(map, settings.frame, file);
        written.add(file);
    };
    return e;
}
}  // namespace voxeland
