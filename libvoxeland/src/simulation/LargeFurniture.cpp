// SPDX-License-Identifier: BSD-3-Clause
#include "Furniture.h"
#include "Piece.h"

namespace voxeland::simulation::furniture
{
namespace
{
const Appearance WHITE{{0.92F, 0.92F, 0.9F}, Texture::Plain, 0};
const Appearance METAL{{0.55F, 0.56F, 0.58F}, Texture::Plain, 0};
const Appearance DARK{{0.12F, 0.12F, 0.13F}, Texture::Plain, 0};

Colour darker(const Colour& c, float f)
{
    return {c.r * f, c.g * f, c.b * f};
}
}  // namespace

ObjectId addChair(Scene& scene, const Pose& pose, const Colour& colour)
{
    const Appearance wood{colour, Texture::Wood, 1},
        frame{darker(colour, 0.75F), Texture::Plain, 1};
    constexpr float SEAT = 0.45F, LEG = 0.04F;
    Piece chair(scene, pose, "chair");
    chair.legs(CHAIR_DEPTH, CHAIR_WIDTH, SEAT - 0.02F, LEG, frame)
        .box({0, 0, SEAT}, {CHAIR_DEPTH, CHAIR_WIDTH, 0.04F}, wood);
    const float back = -CHAIR_DEPTH / 2 + LEG / 2;
    for (const float side : {-1.0F, 1.0F})
        chair.box({back, side * (CHAIR_WIDTH - LEG) / 2, 0.68F}, {LEG, LEG, 0.42F}, frame);
    chair.box({back, 0, 0.78F}, {0.03F, CHAIR_WIDTH - 0.04F, 0.2F}, wood);
    return chair.id();
}

ObjectId addSofa(Scene& scene, const Pose& pose, float width, const Colour& colour)
{
    const Appearance fabric{colour, Texture::Fabric, 2},
        cushion{darker(colour, 1.15F), Texture::Fabric, 3};
    constexpr float ARM = 0.18F, BACK = 0.22F, D = SOFA_DEPTH;
    Piece sofa(scene, pose, "couch");
    sofa.box({0, 0, 0.17F}, {D, width, 0.26F}, fabric)
        .box({-D / 2 + BACK / 2, 0, 0.56F}, {BACK, width, 0.52F}, fabric);
    for (const float side : {-1.0F, 1.0F})
        sofa.box({0, side * (width - ARM) / 2, 0.42F}, {D, ARM, 0.28F}, fabric);
    const int seats = width > 1.9F ? 3 : 2;
    const float seat = (width - 2 * ARM) / static_cast<float>(seats);
    for (int i = 0; i < seats; ++i) {
        const float y = (static_cast<float>(i) - 0.5F * static_cast<float>(seats - 1)) * seat;
        sofa.box({BACK / 2 - 0.01F, y, 0.37F}, {D - BACK, seat - 0.02F, 0.14F}, cushion)
            .box({-D / 2 + BACK + 0.09F, y, 0.6F}, {0.14F, seat - 0.04F, 0.34F}, cushion, -0.18);
    }
    return sofa.id();
}

ObjectId addBed(Scene& scene, const Pose& pose, float width, Random& random)
{
    const Appearance frame{{0.45F, 0.3F, 0.18F}, Texture::Wood, 4};
    const Appearance linen{{0.93F, 0.92F, 0.88F}, Texture::Fabric, 5};
    const Appearance blanket{
        {random.uniform(0.2F, 0.5F), random.uniform(0.35F, 0.5F), 0.65F}, Texture::Fabric, 6};
    constexpr float L = BED_LENGTH;
    Piece bed(scene, pose, "bed");
    bed.legs(L - 0.05F, width, 0.2F, 0.08F, frame)
        .box({0, 0, 0.24F}, {L, width, 0.16F}, frame)
        .box({-L / 2 + 0.03F, 0, 0.55F}, {0.06F, width, 0.7F}, frame)
        .box({0.02F, 0, 0.42F}, {L - 0.1F, width - 0.06F, 0.2F}, linen)
        .box({0.3F, 0, 0.46F}, {L - 0.62F, width, 0.18F}, blanket);
    const int pillows = width > 1.2F ? 2 : 1;
    for (int i = 0; i < pillows; ++i) {
        const float w = width / static_cast<float>(pillows);
        const float y = (static_cast<float>(i) - 0.5F * static_cast<float>(pillows - 1)) * w;
        bed.ellipsoid({-L / 2 + 0.32F, y, 0.55F}, {0.42F, w - 0.12F, 0.18F}, linen);
    }
    return bed.id();
}

ObjectId addToilet(Scene& scene, const Pose& pose)
{
    const Appearance seat{{0.85F, 0.85F, 0.86F}, Texture::Plain, 0};
    Piece toilet(scene, pose, "toilet");
    toilet.box({-0.05F, 0, 0.15F}, {0.4F, 0.22F, 0.3F}, WHITE)
        .ellipsoid({0.07F, 0, 0.29F}, {0.56F, 0.38F, 0.26F}, WHITE)
        .box({-0.05F, 0, 0.41F}, {0.24F, 0.36F, 0.03F}, seat)
        .box({-0.25F, 0, 0.58F}, {0.17F, 0.4F, 0.38F}, WHITE)
        .box({-0.25F, 0, 0.785F}, {0.19F, 0.42F, 0.03F}, seat)
        .cylinder({-0.25F, 0, 0.805F}, 0.025F, 0.015F, METAL);
    return toilet.id();
}

ObjectId addTable(Scene& scene, const Pose& pose, const TableSize& size, const Colour& colour)
{
    const Appearance wood{colour, Texture::Wood, 7}, leg{darker(colour, 0.8F), Texture::Wood, 8};
    Piece table(scene, pose, "dining table");
    table.box({0, 0, size.height - 0.02F}, {size.depth, size.width, 0.04F}, wood)
        .legs(size.depth - 0.06F, size.width - 0.06F, size.height - 0.04F, 0.06F, leg);
    return table.id();
}

ObjectId addCabinet(Scene& scene, const Pose& pose, float width, float height, float depth,
                    const std::string& category, const Colour& colour)
{
    const Appearance wood{colour, Texture::Wood, 9}, door{darker(colour, 1.12F), Texture::Wood, 10};
    Piece cabinet(scene, pose, category);
    cabinet.box({-0.01F, 0, height / 2}, {depth - 0.02F, width, height}, wood);
    const int doors = width > 0.6F ? static_cast<int>(width / 0.45F) : 1;
    const float w = width / static_cast<float>(doors);
    for (int i = 0; i < doors; ++i) {
        const float y = (static_cast<float>(i) - 0.5F * static_cast<float>(doors - 1)) * w;
        cabinet.box({depth / 2 - 0.01F, y, height / 2}, {0.015F, w - 0.02F, height - 0.06F}, door)
            .box({depth / 2 + 0.005F, y + w * 0.35F, height * 0.55F}, {0.02F, 0.02F, 0.14F}, METAL);
    }
    return cabinet.id();
}

ObjectId addBookshelf(Scene& scene, const Pose& pose, Random& random)
{
    const Appearance wood{{0.5F, 0.36F, 0.22F}, Texture::Wood, 11};
    constexpr float D = 0.3F, W = 0.9F, H = 1.7F, BOARD = 0.03F;
    constexpr int SHELVES = 4;
    constexpr float STEP = (H - BOARD) / SHELVES;
    Piece shelf(scene, pose, "bookshelf");
    shelf.box({-D / 2 + 0.01F, 0, H / 2}, {0.02F, W, H}, wood);
    for (const float side : {-1.0F, 1.0F})
        shelf.box({0, side * (W - BOARD) / 2, H / 2}, {D, BOARD, H}, wood);
    for (int i = 0; i <= SHELVES; ++i)
        shelf.box({0, 0, BOARD / 2 + STEP * static_cast<float>(i)}, {D, W, BOARD}, wood);
    for (int i = 0; i < SHELVES; ++i) {
        const float w = random.uniform(0.35F, W - 2 * BOARD - 0.02F),
                    h = random.uniform(0.2F, 0.3F);
        const float y = (W / 2 - BOARD - w / 2) * (random.chance(0.5) ? 1.0F : -1.0F);
        const Appearance spines{{}, Texture::Spines, static_cast<uint32_t>(random.below(1 << 20))};
        const Pose row = pose + Pose(0, y, BOARD + STEP * static_cast<float>(i), 0, 0, 0);
        Piece(scene, row, "book", shelf.id()).box({0, 0, h / 2}, {0.2F, w, h}, spines);
    }
    return shelf.id();
}

ObjectId addPlantStand(Scene& scene, const Pose& pose)
{
    const Appearance wood{{0.62F, 0.47F, 0.3F}, Texture::Wood, 12};
    return Piece(scene, pose, "plant stand")
        .legs(0.36F, 0.36F, 0.56F, 0.04F, wood)
        .box({0, 0, 0.58F}, {0.36F, 0.36F, 0.04F}, wood)
        .id();
}

ObjectId addRefrigerator(Scene& scene, const Pose& pose, Random& random)
{
    const float grey = random.uniform(0.72F, 0.9F), h = random.uniform(1.65F, 1.85F);
    const Appearance body{{grey, grey, grey * 1.02F}, Texture::Plain, 0};
    constexpr float D = 0.64F, W = 0.62F;
    return Piece(scene, pose, "refrigerator")
        .box({-0.03F, 0, h / 2}, {D - 0.06F, W - 0.02F, h}, body)
        .box({D / 2 - 0.03F, 0, h * 0.33F}, {0.05F, W, h * 0.64F}, body)
        .box({D / 2 - 0.03F, 0, h * 0.83F}, {0.05F, W, h * 0.33F}, body)
        .box({D / 2 + 0.01F, W / 2 - 0.07F, h * 0.5F}, {0.03F, 0.025F, 0.3F}, METAL)
        .box({D / 2 + 0.01F, W / 2 - 0.07F, h * 0.78F}, {0.03F, 0.025F, 0.2F}, METAL)
        .box({D / 2 - 0.04F, 0, h * 0.66F}, {0.03F, W - 0.02F, 0.02F}, DARK)
        .id();
}
}  // namespace voxeland::simulation::furniture
