// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/EvaluatedScene.h"

namespace voxeland
{
double iou(const EvaluatedScene& scene, const SharedPoints& overlap)
{
    const size_t both =
        scene.objects[overlap.object].points + scene.instances[overlap.instance].points;
    return static_cast<double>(overlap.points) / static_cast<double>(both - overlap.points);
}

std::vector<size_t> voidPoints(const EvaluatedScene& scene)
{
    std::vector<size_t> points;
    for (const PredictedInstance& i : scene.instances) points.push_back(i.points);
    for (const SharedPoints& o : scene.overlaps)
        if (scene.objects[o.object].cls != NO_CLASS) points[o.instance] -= o.points;
    return points;
}

std::vector<size_t> ignorablePoints(const EvaluatedScene& scene, const EvaluationProtocol& protocol)
{
    std::vector<size_t> points = protocol.voidPolicy == VoidPolicy::ignore
                                     ? voidPoints(scene)
                                     : std::vector<size_t>(scene.instances.size(), 0);
    for (const SharedPoints& o : scene.overlaps) {
        const TrueObject& object = scene.objects[o.object];
        const bool sameClass =
            object.cls != NO_CLASS && object.cls == scene.instances[o.instance].cls;
        if (sameClass && object.points < protocol.minPoints) points[o.instance] += o.points;
    }
    return points;
}

EvaluatedScene classAgnostic(EvaluatedScene scene)
{
    for (TrueObject& o : scene.objects) o.cls = 0;
    for (PredictedInstance& i : scene.instances) i.cls = 0;
    return scene;
}
}  // namespace voxeland
