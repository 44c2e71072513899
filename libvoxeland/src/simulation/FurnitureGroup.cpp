// SPDX-License-Identifier: BSD-3-Clause
#include "FurnitureGroup.h"

#include <array>
#include <cmath>
#include <vector>

namespace voxeland::simulation
{
using namespace furniture;

namespace
{
constexpr double DEG = M_PI / 180;
constexpr float WALL_GAP = 0.03F;  //!< between furniture and the wall behind it [m]

Pose at(const Pose& frame, float x, float y, float z = 0, double yaw = 0)
{
    return frame + Pose(x, y, z, yaw, 0, 0);
}

Colour woodColour(Random& random)
{
    static constexpr std::array<Colour, 5> WOODS{{{0.62F, 0.42F, 0.24F},
                                                  {0.42F, 0.27F, 0.16F},
                                                  {0.76F, 0.6F, 0.4F},
                                                  {0.85F, 0.82F, 0.76F},
                                                  {0.3F, 0.22F, 0.2F}}};
    return WOODS.at(static_cast<size_t>(random.below(5)));
}

Colour fabricColour(Random& random)
{
    static constexpr std::array<Colour, 5> FABRICS{{{0.3F, 0.42F, 0.5F},
                                                    {0.55F, 0.24F, 0.22F},
                                                    {0.4F, 0.46F, 0.3F},
                                                    {0.6F, 0.55F, 0.46F},
                                                    {0.34F, 0.33F, 0.38F}}};
    return FABRICS.at(static_cast<size_t>(random.below(5)));
}

/** Puts different things on a rectangle, each in a slot of its own.
 *  \param top the middle of the rectangle
 *  \param count mean number of things */
void addThings(Scene& scene, const Pose& top, float depth, float width, ObjectId standsOn,
               float count, Random& random)
{
    constexpr float SLOT_X = 0.3F, SLOT_Y = 0.36F;
    const int nx = std::max(1, static_cast<int>(depth / SLOT_X)),
              ny = std::max(1, static_cast<int>(width / SLOT_Y));
    std::vector<std::pair<int, int>> slots;
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j) slots.emplace_back(i, j);
    for (int n = random.poisson(count); n > 0 && !slots.empty(); --n) {
        const auto chosen = slots.begin() + random.below(static_cast<int>(slots.size()));
        const float x = (static_cast<float>(chosen->first) + 0.5F) * depth / static_cast<float>(nx),
                    y = (static_cast<float>(chosen->second) + 0.5F) * width /
                        static_cast<float>(ny);
        slots.erase(chosen);
        const double yaw = random.uniform(-0.5F, 0.5F);
        const Pose place = at(top, x - depth / 2, y - width / 2, 0, yaw);
        switch (random.below(8)) {
            case 0:
                addLaptop(scene, place, standsOn, random);
                break;
            case 1:
            case 2:
                addBooks(scene, place, standsOn, random);
                break;
            case 3:
                addBowl(scene, place, standsOn, random);
                break;
            case 4:
                addBottle(scene, place, standsOn, random);
                break;
            case 5:
                addPottedPlant(scene, place, standsOn, random);
                break;
            default:
                addCup(scene, place, standsOn, random);
        }
    }
}

/** Chairs along one long side of a table, facing it: pushed under it, or pulled out a bit. */
void addChairsAlong(Scene& scene, const Pose& tableSide, float tableWidth, const Colour& colour,
                    Random& random)
{
    const bool touching = random.chance(0.35);
    const float offset = touching ? CHAIR_WIDTH / 2 + 0.004F : tableWidth / 4;
    const float common = random.uniform(-0.05F, 0.34F);
    for (const float y : {-offset, offset}) {
        if (random.chance(0.12)) continue;
        const float tuck = touching ? common : random.uniform(-0.08F, 0.36F);
        const double turned = M_PI + (touching ? 0 : random.uniform(-5.0F, 5.0F) * DEG);
        addChair(scene, at(tableSide, CHAIR_DEPTH / 2 - tuck, y, 0, turned), colour);
    }
}
}  // namespace

FurnitureGroup sofaGroup(const SceneOptions& options, Random& random)
{
    constexpr TableSize LOW{0.55F, 0.95F, 0.42F};
    const bool pair = random.chance(options.pairProbability);
    const float first = pair ? 1.6F : random.uniform(1.9F, 2.3F), second = pair ? 1.6F : 0.0F;
    const float clutter = options.clutterPerTable / 2;
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        const float x = WALL_GAP + SOFA_DEPTH / 2;
        const Colour colour = fabricColour(r);
        addSofa(scene, at(pose, x, -second / 2), first, colour);
        if (pair)
            addSofa(scene, at(pose, x, first / 2 + 0.005F), second,
                    r.chance(0.5) ? colour : fabricColour(r));
        const float tableX = SOFA_DEPTH + 0.4F + LOW.depth / 2;
        const auto table = addTable(scene, at(pose, tableX, 0), LOW, woodColour(r));
        addThings(scene, at(pose, tableX, 0, LOW.height), LOW.depth, LOW.width, table, clutter, r);
    };
    return {first + second + 0.1F, SOFA_DEPTH + 0.4F + LOW.depth + 0.1F, true, build};
}

FurnitureGroup tvGroup(Random& random)
{
    const float width = random.uniform(1.2F, 1.6F);
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        constexpr float HEIGHT = 0.48F;
        const Pose middle = at(pose, WALL_GAP + CABINET_DEPTH / 2, 0);
        const auto stand =
            addCabinet(scene, middle, width, HEIGHT, CABINET_DEPTH, "cabinet", woodColour(r));
        addTv(scene, at(middle, -0.05F, 0, HEIGHT), r.uniform(0.85F, 1.15F), stand, r);
    };
    return {width + 0.1F, CABINET_DEPTH + 0.6F, true, build};
}

FurnitureGroup bedGroup(Random& random)
{
    const float width = random.chance(0.5) ? 1.0F : 1.55F;
    constexpr float STAND = 0.42F;
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        addBed(scene, at(pose, WALL_GAP + BED_LENGTH / 2, 0), width, r);
        const float y = (width / 2 + 0.03F + STAND / 2) * (r.chance(0.5) ? 1.0F : -1.0F);
        const Pose middle = at(pose, WALL_GAP + STAND / 2, y);
        const auto stand =
            addCabinet(scene, middle, STAND, 0.5F, STAND, "nightstand", woodColour(r));
        addThings(scene, at(middle, 0, 0, 0.5F), 0.3F, 0.3F, stand, 1.5F, r);
    };
    return {width + 2 * STAND + 0.1F, BED_LENGTH + 0.1F, true, build};
}

FurnitureGroup diningGroup(const SceneOptions& options, Random& random)
{
    const int tables = random.chance(options.pairProbability) ? 2 : 1;
    const TableSize size{random.uniform(0.75F, 0.9F), random.uniform(1.3F, 1.5F), 0.74F};
    const float clutter = options.clutterPerTable;
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        const Colour wood = woodColour(r), chairs = woodColour(r);
        for (int i = 0; i < tables; ++i) {
            const float y = (static_cast<float>(i) - 0.5F * static_cast<float>(tables - 1)) *
                            (size.width + 0.004F);
            const Pose middle = at(pose, 0, y);
            const auto table = addTable(scene, middle, size, wood);
            addThings(scene, at(middle, 0, 0, size.height), size.depth, size.width, table, clutter,
                      r);
            addChairsAlong(scene, at(middle, size.depth / 2, 0), size.width, chairs, r);
            addChairsAlong(scene, at(middle, -size.depth / 2, 0, 0, M_PI), size.width, chairs, r);
        }
    };
    constexpr float PASSAGE = 0.25F;  // behind the chairs
    return {size.width * static_cast<float>(tables) + PASSAGE,
            size.depth + 2 * (CHAIR_DEPTH + PASSAGE), false, build};
}

FurnitureGroup kitchenGroup(const SceneOptions& options)
{
    constexpr float FRIDGE = 0.64F, DEPTH = 0.6F, COUNTER = 1.5F, HEIGHT = 0.9F;
    const float clutter = options.clutterPerTable / 2;
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        addRefrigerator(scene, at(pose, WALL_GAP + 0.33F, -COUNTER / 2 - 0.01F), r);
        const Pose middle = at(pose, WALL_GAP + DEPTH / 2, FRIDGE / 2);
        const auto counter =
            addCabinet(scene, middle, COUNTER, HEIGHT, DEPTH, "kitchen cabinet", woodColour(r));
        addMicrowave(scene, at(middle, -0.05F, COUNTER / 2 - 0.3F, HEIGHT), counter, r);
        addThings(scene, at(middle, 0, -0.25F, HEIGHT), DEPTH - 0.1F, COUNTER - 0.6F, counter,
                  clutter, r);
    };
    return {FRIDGE + COUNTER + 0.1F, 0.8F, true, build};
}

FurnitureGroup deskGroup(Random& random)
{
    const TableSize size{0.66F, random.uniform(1.2F, 1.5F), 0.74F};
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        const Pose middle = at(pose, WALL_GAP + size.depth / 2, 0);
        const auto desk = addTable(scene, middle, size, woodColour(r));
        const Pose top = at(middle, 0, 0, size.height);
        if (r.chance(0.5))
            addTv(scene, at(top, -0.12F, 0), 0.55F, desk, r);
        else
            addLaptop(scene, at(top, 0, 0), desk, r);
        addBooks(scene, at(top, -0.1F, -size.width / 2 + 0.2F), desk, r);
        addCup(scene, at(top, 0.1F, size.width / 2 - 0.15F), desk, r);
        const float front = WALL_GAP + size.depth;
        const float tuck = r.uniform(0.0F, 0.3F);
        addChair(scene, at(pose, front + CHAIR_DEPTH / 2 - tuck, 0, 0, M_PI), woodColour(r));
        addBackpack(scene, at(pose, 0.3F, size.width / 2 + 0.25F), r);
    };
    return {size.width + 0.9F, size.depth + CHAIR_DEPTH + 0.1F, true, build};
}

FurnitureGroup toiletGroup()
{
    constexpr float WIDTH = 1.2F, DEPTH = 1.3F, SCREEN = 0.06F, HEIGHT = 1.9F;
    const auto build = [=](Scene& scene, const Pose& pose, Random&) {
        addToilet(scene, at(pose, WALL_GAP + 0.36F, 0));
        const Pose screen = at(pose, 0.55F, (WIDTH - SCREEN) / 2, HEIGHT / 2);
        const Appearance tiles{{0.75F, 0.84F, 0.86F}, Texture::Plain, 0};
        scene.addSolid(Solid(Solid::Shape::Box, screen.asTPose(),
                             {0.55F - 0.005F, SCREEN / 2, HEIGHT / 2}, tiles));
    };
    return {WIDTH, DEPTH, true, build};
}

FurnitureGroup chairRow(Random& random)
{
    const int chairs = 2 + random.below(2);
    const float width = static_cast<float>(chairs) * (CHAIR_WIDTH + 0.006F);
    const auto build = [=](Scene& scene, const Pose& pose, Random& r) {
        const Colour colour = woodColour(r);
        for (int i = 0; i < chairs; ++i) {
            const float y = (static_cast<float>(i) + 0.5F) * (CHAIR_WIDTH + 0.006F) - width / 2;
            addChair(scene, at(pose, WALL_GAP + CHAIR_DEPTH / 2, y), colour);
        }
    };
    return {width + 0.1F, CHAIR_DEPTH + 0.4F, true, build};
}

FurnitureGroup bookshelfGroup()
{
    const auto build = [](Scene& scene, const Pose& pose, Random& r) {
        addBookshelf(scene, at(pose, WALL_GAP + 0.15F, 0), r);
    };
    return {1.0F, 0.8F, true, build};
}

FurnitureGroup backpackGroup()
{
    const auto build = [](Scene& scene, const Pose& pose, Random& r) {
        addBackpack(scene, at(pose, 0.2F, 0), r);
    };
    return {0.5F, 0.5F, true, build};
}

FurnitureGroup unknownGroup(Random& random)
{
    switch (random.below(5)) {
        case 0:
            return {1.1F, 1.0F, true, [](Scene& scene, const Pose& pose, Random& r) {
                        addCabinet(scene, at(pose, WALL_GAP + 0.28F, 0), 0.95F, 1.85F, 0.55F,
                                   "wardrobe", woodColour(r));
                    }};
        case 1:
            return {0.5F, 0.5F, true, [](Scene& scene, const Pose& pose, Random& r) {
                        const auto stand = addPlantStand(scene, at(pose, WALL_GAP + 0.2F, 0));
                        addPottedPlant(scene, at(pose, WALL_GAP + 0.2F, 0, 0.6F), stand, r);
                    }};
        case 2:
            return {0.6F, 0.6F, true, [](Scene& scene, const Pose& pose, Random& r) {
                        addCardboardBox(scene, at(pose, 0.3F, 0, 0, r.uniform(-0.1F, 0.1F)), r);
                    }};
        case 3:
            return {0.45F, 0.45F, true, [](Scene& scene, const Pose& pose, Random&) {
                        addFloorLamp(scene, at(pose, 0.22F, 0));
                    }};
        default:
            return {1.0F, 0.3F, true, [](Scene& scene, const Pose& pose, Random& r) {
                        addPicture(scene, at(pose, 0.001F, 0, 1.5F), r);
                    }};
    }
}
}  // namespace voxeland::simulation
