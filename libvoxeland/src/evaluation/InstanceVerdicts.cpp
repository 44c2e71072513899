// SPDX-License-Identifier: BSD-3-Clause
#include "InstanceVerdicts.h"

namespace voxeland
{
namespace
{
void judgeCategories(const EvaluatedScene& scene, size_t minPoints,
                     std::vector<InstanceVerdict>& verdicts)
{
    const auto objects = objectsOfInstances(scene, minPoints);
    for (size_t i = 0; i < objects.size(); ++i) {
        if (!objects[i]) continue;
        const PredictedInstance& instance = scene.instances[i];
        const class_id_t truth = scene.objects[*objects[i]].cls;
        if (truth == NO_CLASS && instance.cls == NO_CLASS) continue;
        verdicts.push_back({instance.entropy, instance.probability, truth == instance.cls});
    }
}

void judgeDetections(const EvaluatedScene& scene, const EvaluationProtocol& protocol,
                     std::vector<InstanceVerdict>& verdicts)
{
    std::vector<bool> correct(scene.instances.size(), false), onSmallObject = correct;
    for (const SharedPoints& o : scene.overlaps) {
        const TrueObject& object = scene.objects[o.object];
        if (object.cls != scene.instances[o.instance].cls || iou(scene, o) < 0.5) continue;
        (object.points < protocol.minPoints ? onSmallObject : correct)[o.instance] = true;
    }
    const std::vector<size_t> ignorable = ignorablePoints(scene, protocol);
    for (size_t i = 0; i < scene.instances.size(); ++i) {
        const PredictedInstance& instance = scene.instances[i];
        if (instance.cls == NO_CLASS || instance.points == 0 ||
            instance.points < protocol.minPoints)
            continue;
        const bool ignored = onSmallObject[i] || 2 * ignorable[i] > instance.points;
        if (!correct[i] && ignored) continue;
        verdicts.push_back({instance.entropy, instance.probability, correct[i]});
    }
}
}  // namespace

std::vector<std::optional<size_t>> objectsOfInstances(const EvaluatedScene& scene, size_t minPoints)
{
    std::vector<const SharedPoints*> largest(scene.instances.size(), nullptr);
    for (const SharedPoints& o : scene.overlaps) {
        const SharedPoints*& best = largest[o.instance];
        if (best == nullptr || o.points > best->points) best = &o;
    }
    std::vector<std::optional<size_t>> objects(scene.instances.size());
    for (size_t i = 0; i < scene.instances.size(); ++i) {
        const size_t points = scene.instances[i].points;
        if (largest[i] == nullptr || points < minPoints) continue;
        if (iou(scene, *largest[i]) > 0.25 || 2 * largest[i]->points > points)
            objects[i] = largest[i]->object;
    }
    return objects;
}

std::vector<InstanceVerdict> categoryVerdicts(const std::vector<EvaluatedScene>& scenes,
                                              const EvaluationProtocol& protocol)
{
    std::vector<InstanceVerdict> verdicts;
    for (const EvaluatedScene& s : scenes) judgeCategories(s, protocol.minPoints, verdicts);
    return verdicts;
}

std::vector<InstanceVerdict> detectionVerdicts(const std::vector<EvaluatedScene>& scenes,
                                               const EvaluationProtocol& protocol)
{
    std::vector<InstanceVerdict> verdicts;
    for (const EvaluatedScene& s : scenes) judgeDetections(s, protocol, verdicts);
    return verdicts;
}
}  // namespace voxeland
