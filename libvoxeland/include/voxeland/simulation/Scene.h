// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Solid.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxeland::simulation
{
/** Identity of what a surface belongs to; objects count from 1. */
using ObjectId = uint16_t;
constexpr ObjectId STRUCTURE = 0;  //!< walls, floors, ceilings: no object

/** A piece of furniture or a thing. */
struct SceneObject
{
    ObjectId id = STRUCTURE;
    std::string category;           //!< true category, e.g. "dining table"
    ObjectId standsOn = STRUCTURE;  //!< the object it rests on, if any
    Bounds bounds;                  //!< in the world
};

/** Inside of a room; the floor is at z = 0. */
struct Room
{
    float minX = 0, minY = 0, maxX = 0, maxY = 0;  //!< inner faces of its walls [m]
};

/** Everything there is to see: solids, each belonging to an object or to the structure. */
class Scene
{
 public:
    /** A solid and what it is part of. */
    struct Part
    {
        Solid solid;
        ObjectId object;
    };

    /** Adds an object without a body yet. \return its id */
    ObjectId addObject(const std::string& category, ObjectId standsOn = STRUCTURE);
    /** Adds a solid to an object's body, or to the structure. */
    void addSolid(const Solid& solid, ObjectId object = STRUCTURE);
    /** Gives all of an object's body one colour. */
    void paint(ObjectId object, const Colour& colour);
    void addRoom(const Room& room) { m_rooms.push_back(room); }

    [[nodiscard]] const std::vector<Part>& parts() const { return m_parts; }
    [[nodiscard]] const std::vector<Room>& rooms() const { return m_rooms; }
    /** All objects; that with id i is at i-1. */
    [[nodiscard]] const std::vector<SceneObject>& objects() const { return m_objects; }
    /** \throws std::out_of_range if there is none */
    [[nodiscard]] const SceneObject& object(ObjectId id) const { return m_objects.at(id - 1U); }
    /** Objects that touch this one, or nearly. */
    [[nodiscard]] std::vector<ObjectId> touching(ObjectId id) const;

    /** Points all over the visible surface of an object, or of the structure: those inside
     *  another of its solids are left out. \param spacing see Solid::sampleSurface() */
    [[nodiscard]] std::vector<SurfacePoint> sampleSurface(ObjectId id, float spacing) const;

 private:
    std::vector<Part> m_parts;
    std::vector<SceneObject> m_objects;
    std::vector<Room> m_rooms;
};
}  // namespace voxeland::simulation
