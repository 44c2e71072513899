// SPDX-License-Identifier: BSD-3-Clause
#include "PanopticQuality.h"

#include <limits>

namespace voxeland
{
namespace
{
void addScene(const EvaluatedScene& scene, class_id_t cls, const EvaluationProtocol& protocol,
              PanopticQuality& q)
{
    const auto counts = [&](const auto& segment) {
        return segment.cls == cls && segment.points > 0 && segment.points >= protocol.minPoints;
    };
    const bool ignoreVoid = protocol.voidPolicy == VoidPolicy::ignore;
    const std::vector<size_t> empty = voidPoints(scene);
    const std::vector<size_t> ignorable = ignorablePoints(scene, protocol);
    std::vector<bool> matched(scene.instances.size(), false);
    size_t objects = 0, found = 0;
    for (const SharedPoints& o : scene.overlaps) {
        const TrueObject& object = scene.objects[o.object];
        const PredictedInstance& instance = scene.instances[o.instance];
        if (!counts(object) || !counts(instance)) continue;
        const size_t inUnion = instance.points - (ignoreVoid ? empty[o.instance] : 0);
        const double overlap =
            static_cast<double>(o.points) / static_cast<double>(object.points + inUnion - o.points);
        if (overlap <= 0.5) continue;  // above, no other pair can match either side
        matched[o.instance] = true;
        ++found;
        q.iouSum += overlap;
    }
    for (const TrueObject& o : scene.objects)
        if (counts(o)) ++objects;
    for (size_t i = 0; i < scene.instances.size(); ++i)
        if (counts(scene.instances[i]) && !matched[i] &&
            2 * ignorable[i] <= scene.instances[i].points)
            ++q.unmatchedInstances;
    q.matched += found;
    q.missedObjects += objects - found;
}
}  // namespace

double PanopticQuality::segmentation() const
{
    return matched == 0 ? 0 : iouSum / static_cast<double>(matched);
}

double PanopticQuality::recognition() const
{
    const size_t doubled = 2 * matched + unmatchedInstances + missedObjects;
    if (doubled == 0) return std::numeric_limits<double>::quiet_NaN();
    return 2 * static_cast<double>(matched) / static_cast<double>(doubled);
}

double PanopticQuality::quality() const
{
    return segmentation() * recognition();
}

PanopticQuality panopticQuality(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                                const EvaluationProtocol& protocol)
{
    PanopticQuality q;
    for (const EvaluatedScene& s : scenes) addScene(s, cls, protocol, q);
    return q;
}
}  // namespace voxeland
