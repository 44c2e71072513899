// SPDX-License-Identifier: BSD-3-Clause
#include "Segmentation.h"

namespace voxeland
{
namespace
{
void addScene(const EvaluatedScene& scene, size_t minPoints, SegmentationCounts& counts)
{
    std::vector<size_t> parts(scene.objects.size(), 0);
    std::vector<const SharedPoints*> largest(scene.objects.size(), nullptr);
    for (const SharedPoints& o : scene.overlaps) {
        const TrueObject& object = scene.objects[o.object];
        if (object.points < minPoints || 10 * o.points < object.points) continue;
        ++parts[o.object];
        const SharedPoints*& best = largest[o.object];
        if (best == nullptr || o.points > best->points) best = &o;
    }
    std::vector<size_t> covered(scene.instances.size(), 0);
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].points >= minPoints) ++counts.objects;
        if (parts[i] >= 2) ++counts.overSegmented;
        if (largest[i] == nullptr) continue;
        ++counts.coveredObjects;
        ++covered[largest[i]->instance];
    }
    for (size_t i = 0; i < scene.instances.size(); ++i) {
        if (scene.instances[i].points >= minPoints) ++counts.instances;
        if (covered[i] >= 2) ++counts.underSegmented;
    }
}
}  // namespace

SegmentationCounts segmentationCounts(const std::vector<EvaluatedScene>& scenes,
                                      const EvaluationProtocol& protocol)
{
    SegmentationCounts counts;
    for (const EvaluatedScene& s : scenes) addScene(s, protocol.minPoints, counts);
    return counts;
}
}  // namespace voxeland
