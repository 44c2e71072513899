// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Scene.h"

#include <algorithm>
#include <stdexcept>

namespace voxeland::simulation
{
ObjectId Scene::addObject(const std::string& category, ObjectId standsOn)
{
    SceneObject object;
    object.id = static_cast<ObjectId>(m_objects.size() + 1);
    object.category = category;
    object.standsOn = standsOn;
    m_objects.push_back(object);
    return object.id;
}

void Scene::addSolid(const Solid& solid, ObjectId object)
{
    if (object > m_objects.size())
        throw std::invalid_argument("a solid belongs to object " + std::to_string(object) +
                                    ", which does not exist");
    m_parts.push_back({solid, object});
    if (object != STRUCTURE) m_objects[object - 1U].bounds.include(solid.bounds());
}

void Scene::paint(ObjectId object, const Colour& colour)
{
    for (Part& part : m_parts)
        if (part.object == object) part.solid.setAppearance({colour, Texture::Plain, 0});
}

std::vector<ObjectId> Scene::touching(ObjectId id) const
{
    constexpr float GAP = 0.03F;
    std::vector<ObjectId> result;
    for (const auto& other : m_objects)
        if (other.id != id && other.bounds.near(object(id).bounds, GAP)) result.push_back(other.id);
    return result;
}

std::vector<SurfacePoint> Scene::sampleSurface(ObjectId id, float spacing) const
{
    constexpr float SKIN = 1e-3F;  // surfaces in contact stay: they may be visible elsewhere
    std::vector<const Solid*> body;
    for (const auto& part : m_parts)
        if (part.object == id) body.push_back(&part.solid);

    std::vector<SurfacePoint> result;
    for (const Solid* solid : body) {
        std::vector<const Solid*> neighbours;
        for (const Solid* other : body)
            if (other != solid && other->bounds().near(solid->bounds(), 0))
                neighbours.push_back(other);
        for (const auto& point : solid->sampleSurface(spacing)) {
            const bool inside =
                std::any_of(neighbours.begin(), neighbours.end(),
                            [&](const Solid* s) { return s->contains(point.position, SKIN); });
            if (!inside) result.push_back(point);
        }
    }
    return result;
}
}  // namespace voxeland::simulation
