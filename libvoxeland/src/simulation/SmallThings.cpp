// SPDX-License-Identifier: BSD-3-Clause
#include "Furniture.h"
#include "Piece.h"

namespace voxeland::simulation::furniture
{
namespace
{
const Appearance BLACK{{0.07F, 0.07F, 0.08F}, Texture::Plain, 0};
const Appearance SILVER{{0.66F, 0.67F, 0.69F}, Texture::Plain, 0};

Colour vivid(Random& random)
{
    Colour c{random.uniform(0.1F, 0.35F), random.uniform(0.1F, 0.35F), random.uniform(0.1F, 0.35F)};
    float* const strong[] = {&c.r, &c.g, &c.b};
    *strong[random.below(3)] = random.uniform(0.6F, 0.9F);
    return c;
}

uint32_t variation(Random& random)
{
    return static_cast<uint32_t>(random.below(1 << 20));
}
}  // namespace

ObjectId addTv(Scene& scene, const Pose& pose, float width, ObjectId standsOn, Random& random)
{
    const float h = width * 0.58F;
    const Appearance screen{{}, Texture::Screen, variation(random)};
    return Piece(scene, pose, "tv", standsOn)
        .box({0, 0, 0.01F}, {0.2F, width * 0.4F, 0.02F}, BLACK)
        .box({0, 0, 0.05F}, {0.04F, 0.1F, 0.08F}, BLACK)
        .box({0, 0, 0.08F + h / 2}, {0.05F, width, h}, BLACK)
        .box({0.025F, 0, 0.08F + h / 2}, {0.006F, width - 0.04F, h - 0.04F}, screen)
        .id();
}

ObjectId addLaptop(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    const Appearance screen{{}, Texture::Screen, variation(random)};
    return Piece(scene, pose, "laptop", standsOn)
        .box({0.03F, 0, 0.01F}, {0.24F, 0.34F, 0.02F}, SILVER)
        .box({0.05F, 0, 0.021F}, {0.14F, 0.3F, 0.003F}, BLACK)
        .box({-0.125F, 0, 0.125F}, {0.012F, 0.34F, 0.23F}, SILVER, -0.3)
        .box({-0.119F, 0, 0.125F}, {0.006F, 0.31F, 0.2F}, screen, -0.3)
        .id();
}

ObjectId addBooks(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    Piece books(scene, pose, "book", standsOn);
    float top = 0;
    for (int i = 3 + random.below(4); i > 0; --i) {
        const float thickness = random.uniform(0.02F, 0.045F), w = random.uniform(0.2F, 0.27F);
        const float x = random.uniform(-0.015F, 0.015F), y = random.uniform(-0.015F, 0.015F);
        const Appearance cover{vivid(random), Texture::Plain, 0},
            pages{{0.93F, 0.9F, 0.8F}, Texture::Plain, 0};
        books.box({x, y, top + thickness / 2}, {0.17F, w - 0.008F, thickness - 0.006F}, pages);
        for (const float side : {top + 0.002F, top + thickness - 0.002F})
            books.box({x, y, side}, {0.18F, w, 0.004F}, cover);
        top += thickness;
    }
    return books.id();
}

ObjectId addCup(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    const Appearance glaze{vivid(random), Texture::Plain, 0};
    return Piece(scene, pose, "cup", standsOn)
        .cylinder({0, 0, 0.05F}, 0.042F, 0.1F, glaze)
        .box({0, 0.055F, 0.05F}, {0.012F, 0.03F, 0.06F}, glaze)
        .id();
}

ObjectId addBottle(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    const Appearance glass{{0.1F, random.uniform(0.35F, 0.5F), 0.18F}, Texture::Plain, 0};
    const Appearance label{{0.9F, 0.85F, 0.7F}, Texture::Plain, 0};
    return Piece(scene, pose, "bottle", standsOn)
        .cylinder({0, 0, 0.09F}, 0.04F, 0.18F, glass)
        .cylinder({0, 0, 0.09F}, 0.041F, 0.08F, label)
        .ellipsoid({0, 0, 0.18F}, {0.08F, 0.08F, 0.06F}, glass)
        .cylinder({0, 0, 0.24F}, 0.016F, 0.1F, glass)
        .id();
}

ObjectId addBowl(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    const Appearance glaze{{0.85F, 0.75F, 0.6F}, Texture::Plain, 0};
    Piece bowl(scene, pose, "bowl", standsOn);
    bowl.cylinder({0, 0, 0.01F}, 0.06F, 0.02F, glaze).cylinder({0, 0, 0.045F}, 0.12F, 0.05F, glaze);
    for (int i = 0; i < 4; ++i) {
        const float x = 0.05F * (i % 2 == 0 ? 1.0F : -1.0F),
                    y = 0.05F * (i / 2 == 0 ? 1.0F : -1.0F);
        const Appearance fruit{{0.85F, random.uniform(0.15F, 0.7F), 0.1F}, Texture::Plain, 0};
        bowl.ellipsoid({x, y, 0.085F}, {0.08F, 0.08F, 0.08F}, fruit);
    }
    return bowl.id();
}

ObjectId addMicrowave(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    const float grey = random.uniform(0.55F, 0.8F);
    const Appearance body{{grey, grey, grey}, Texture::Plain, 0};
    return Piece(scene, pose, "microwave", standsOn)
        .box({0, 0, 0.15F}, {0.36F, 0.5F, 0.3F}, body)
        .box({0.18F, 0.05F, 0.15F}, {0.01F, 0.34F, 0.22F}, BLACK)
        .box({0.18F, -0.19F, 0.15F}, {0.01F, 0.08F, 0.24F}, SILVER)
        .id();
}

ObjectId addBackpack(Scene& scene, const Pose& pose, Random& random)
{
    const Appearance cloth{vivid(random), Texture::Fabric, variation(random)};
    const Appearance pocket{{cloth.colour.r * 0.7F, cloth.colour.g * 0.7F, cloth.colour.b * 0.7F},
                            Texture::Fabric,
                            variation(random)};
    return Piece(scene, pose, "backpack")
        .box({0, 0, 0.19F}, {0.2F, 0.32F, 0.34F}, cloth, -0.08)
        .ellipsoid({-0.01F, 0, 0.34F}, {0.2F, 0.32F, 0.2F}, cloth)
        .box({0.11F, 0, 0.14F}, {0.08F, 0.24F, 0.2F}, pocket, -0.08)
        .box({-0.02F, 0, 0.45F}, {0.02F, 0.08F, 0.05F}, BLACK)
        .id();
}

ObjectId addPottedPlant(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random)
{
    const Appearance pot{{0.68F, 0.36F, 0.24F}, Texture::Plain, 0};
    Piece plant(scene, pose, "potted plant", standsOn);
    plant.cylinder({0, 0, 0.09F}, 0.1F, 0.18F, pot);
    for (int i = 0; i < 7; ++i) {
        const Appearance leaf{
            {0.15F, random.uniform(0.35F, 0.6F), 0.15F}, Texture::Fabric, variation(random)};
        plant.ellipsoid({random.uniform(-0.09F, 0.09F), random.uniform(-0.09F, 0.09F),
                         random.uniform(0.22F, 0.45F)},
                        {0.16F, 0.16F, 0.2F}, leaf);
    }
    return plant.id();
}

ObjectId addCardboardBox(Scene& scene, const Pose& pose, Random& random)
{
    const Appearance cardboard{{0.72F, 0.56F, 0.36F}, Texture::Plain, 0};
    const Appearance tape{{0.85F, 0.75F, 0.5F}, Texture::Plain, 0};
    const float d = random.uniform(0.3F, 0.42F), h = random.uniform(0.28F, 0.42F);
    return Piece(scene, pose, "box")
        .box({0, 0, h / 2}, {d, 0.5F, h}, cardboard)
        .box({0, 0, h / 2}, {0.05F, 0.504F, h + 0.004F}, tape)
        .id();
}

ObjectId addFloorLamp(Scene& scene, const Pose& pose)
{
    const Appearance shade{{0.96F, 0.9F, 0.7F}, Texture::Plain, 0};
    return Piece(scene, pose, "floor lamp")
        .cylinder({0, 0, 0.015F}, 0.15F, 0.03F, BLACK)
        .cylinder({0, 0, 0.75F}, 0.018F, 1.46F, BLACK)
        .cylinder({0, 0, 1.55F}, 0.18F, 0.28F, shade)
        .id();
}

ObjectId addPicture(Scene& scene, const Pose& pose, Random& random)
{
    const Appearance frame{{0.2F, 0.14F, 0.1F}, Texture::Plain, 0};
    const Appearance canvas{{}, Texture::Painting, variation(random)};
    const float w = random.uniform(0.5F, 0.9F), h = random.uniform(0.4F, 0.6F);
    return Piece(scene, pose, "picture")
        .box({0.015F, 0, 0}, {0.03F, w, h}, frame)
        .box({0.028F, 0, 0}, {0.01F, w - 0.08F, h - 0.08F}, canvas)
        .id();
}
}  // namespace voxeland::simulation::furniture
