// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evaluation/EvaluatedScene.h"

namespace voxeland::test
{
/** Makes scenes of counts by hand. */
class SceneBuilder
{
 public:
    SceneBuilder& object(class_id_t cls, size_t points)
    {
        TrueObject o;
        o.id = static_cast<uint32_t>(m_scene.objects.size() + 1);
        o.cls = cls;
        o.points = points;
        m_scene.objects.push_back(o);
        return *this;
    }
    SceneBuilder& instance(class_id_t cls, size_t points, double score)
    {
        PredictedInstance i;
        i.id = static_cast<instance_id_t>(m_scene.instances.size() + 1);
        i.cls = cls;
        i.points = points;
        i.score = i.probability = score;
        i.entropy = 1 - score;
        m_scene.instances.push_back(i);
        return *this;
    }
    /** Both counted from 0; to be called in order of object, then instance. */
    SceneBuilder& overlap(size_t object, size_t instance, size_t points)
    {
        m_scene.overlaps.push_back({object, instance, points});
        return *this;
    }
    operator std::vector<EvaluatedScene>() const { return {m_scene}; }
    operator EvaluatedScene() const { return m_scene; }

 private:
    EvaluatedScene m_scene;
};
}  // namespace voxeland::test
