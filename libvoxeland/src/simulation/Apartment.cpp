// SPDX-License-Identifier: BSD-3-Clause
#include "Apartment.h"

#include "CategoryPaint.h"
#include "FloorPlan.h"
#include "FurnitureGroup.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace voxeland::simulation
{
namespace
{
constexpr float WALL = 0.12F;                             //!< thickness of walls and floors [m]
constexpr float DOOR_WIDTH = 0.95F, DOOR_HEIGHT = 2.05F;  //!< of the openings [m]

void addBlock(Scene& scene, const Vector3& min, const Vector3& max, const Appearance& appearance)
{
    const Vector3 c = (min + max) * 0.5F;
    scene.addSolid(
        Solid(Solid::Shape::Box, {c.x, c.y, c.z, 0, 0, 0}, (max - min) * 0.5F, appearance));
}

Appearance paint(Random& random)
{
    const float warm = random.uniform(0.0F, 0.08F);
    return {{0.88F, 0.86F - warm / 2, 0.82F - warm}, Texture::Plain, 0};
}

/** Floor, ceiling and the two walls along x. */
void addShell(Scene& scene, const Room& r, float height, Random& random)
{
    const Appearance wall = paint(random), white{{0.95F, 0.95F, 0.94F}, Texture::Plain, 0};
    const float tone = random.uniform(0.75F, 1.0F);
    const Appearance floor{{0.66F * tone, 0.5F * tone, 0.34F * tone}, Texture::Planks, 1};
    const float x0 = r.minX - WALL / 2, x1 = r.maxX + WALL / 2;
    addBlock(scene, {x0, r.minY - WALL, -WALL}, {x1, r.maxY + WALL, 0}, floor);
    addBlock(scene, {x0, r.minY - WALL, height}, {x1, r.maxY + WALL, height + WALL}, white);
    addBlock(scene, {x0, r.minY - WALL, 0}, {x1, r.minY, height}, wall);
    addBlock(scene, {x0, r.maxY, 0}, {x1, r.maxY + WALL, height}, wall);
}

/** The wall between two rooms, with an opening around y. */
void addWallWithDoor(Scene& scene, float x, float maxY, float height, float y, Random& random)
{
    const Appearance wall = paint(random);
    const float left = y - DOOR_WIDTH / 2, right = y + DOOR_WIDTH / 2;
    addBlock(scene, {x, -WALL, 0}, {x + WALL, left, height}, wall);
    addBlock(scene, {x, right, 0}, {x + WALL, maxY + WALL, height}, wall);
    addBlock(scene, {x, left, DOOR_HEIGHT}, {x + WALL, right, height}, wall);
}

/** What must stand in room `index` of `count`. Large groups come first: they are hard to place. */
std::vector<FurnitureGroup> furnitureOf(int index, int count, const SceneOptions& o, Random& r)
{
    std::vector<FurnitureGroup> groups;
    const bool living = index == 0, kitchen = count < 3 ? index == 0 : index == 1,
               bedroom = index == count - 1;
    if (kitchen) groups.push_back(diningGroup(o, r));
    if (living) groups.push_back(sofaGroup(o, r));
    if (bedroom) groups.push_back(bedGroup(r));
    if (kitchen) groups.push_back(kitchenGroup(o));
    if (bedroom && count > 1) groups.push_back(deskGroup(r));
    if (bedroom && count > 1) groups.push_back(toiletGroup());
    if (living) groups.push_back(tvGroup(r));
    if (kitchen && count == 3) groups.push_back(chairRow(r));
    if (living && count > 1) groups.push_back(bookshelfGroup());
    if (living) groups.push_back(backpackGroup());
    return groups;
}

Vector3 roomSize(int index, int count, Random& random)
{
    const bool large = index == 0 && count < 3;
    const float more = large ? 1.7F : 0.0F;
    const float x = random.uniform(4.6F, 5.2F) + more;
    return {x, random.uniform(4.5F, 5.1F) + (large ? 0.5F : 0.0F), 0};
}

/** Furniture with its place, and the floor that is left. */
struct Arrangement
{
    FloorPlan rest;
    std::vector<mrpt::poses::CPose3D> places;
};

/** Chooses places for all groups; none if they did not fit this time. */
std::optional<Arrangement> arrange(const FloorPlan& empty,
                                   const std::vector<FurnitureGroup>& groups, Random& random)
{
    Arrangement result{empty, {}};
    for (const auto& group : groups) {
        const auto place = result.rest.place(group, random);
        if (!place) return std::nullopt;
        result.places.push_back(*place);
    }
    return result;
}

void furnish(Scene& scene, const FloorPlan& empty, const std::vector<FurnitureGroup>& groups,
             float unknowns, Random& random)
{
    constexpr int ATTEMPTS = 200;
    std::optional<Arrangement> found;
    for (int i = 0; i < ATTEMPTS && !found; ++i) found = arrange(empty, groups, random);
    if (!found) throw std::runtime_error("the furniture does not fit into a room");

    for (size_t i = 0; i < groups.size(); ++i) groups[i].build(scene, found->places[i], random);
    for (int n = random.poisson(unknowns); n > 0; --n) {
        const FurnitureGroup group = unknownGroup(random);
        if (const auto place = found->rest.place(group, random)) group.build(scene, *place, random);
    }
}
}  // namespace

Scene makeApartment(const SceneOptions& options, Random random)
{
    Scene scene;
    const float height = options.roomHeight;
    std::vector<FloorPlan> plans;
    float x = 0;
    for (int i = 0; i < options.rooms; ++i) {
        const Vector3 size = roomSize(i, options.rooms, random);
        const Room room{x, 0, x + size.x, size.y};
        scene.addRoom(room);
        plans.emplace_back(room);
        addShell(scene, room, height, random);
        x = room.maxX + WALL;
    }

    const auto& rooms = scene.rooms();
    addBlock(scene, {-WALL, -WALL, 0}, {0, rooms.front().maxY + WALL, height}, paint(random));
    for (size_t i = 0; i + 1 < rooms.size(); ++i) {
        const float shared = std::min(rooms[i].maxY, rooms[i + 1].maxY), wall = rooms[i].maxX;
        const float y = random.uniform(0.8F, shared - 0.8F);
        addWallWithDoor(scene, wall, std::max(rooms[i].maxY, rooms[i + 1].maxY), height, y, random);
        const float left = y - DOOR_WIDTH / 2 - 0.1F, right = y + DOOR_WIDTH / 2 + 0.1F;
        plans[i].reserve({wall - 0.9F, left, wall, right});
        plans[i + 1].reserve({wall + WALL, left, wall + WALL + 0.9F, right});
    }
    const float end = rooms.back().maxX;
    addBlock(scene, {end, -WALL, 0}, {end + WALL, rooms.back().maxY + WALL, height}, paint(random));

    for (int i = 0; i < options.rooms; ++i)
        furnish(scene, plans[static_cast<size_t>(i)],
                furnitureOf(i, options.rooms, options, random), options.unknownPerRoom, random);
    if (options.painted)
        for (const SceneObject& object : scene.objects())
            scene.paint(object.id, paintOf(object.category));
    return scene;
}
}  // namespace voxeland::simulation
