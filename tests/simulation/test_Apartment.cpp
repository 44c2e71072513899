// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/Apartment.h"
#include "voxeland/simulation/Recognition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace voxeland::simulation;

namespace
{
Scene apartment(int rooms, uint64_t seed)
{
    SceneOptions options;
    options.rooms = rooms;
    return makeApartment(options, Random(seed));
}

std::map<std::string, int> counts(const Scene& scene)
{
    std::map<std::string, int> result;
    for (const auto& object : scene.objects()) ++result[object.category];
    return result;
}
}  // namespace

class Apartments : public ::testing::TestWithParam<std::tuple<int, uint64_t>>
{
 protected:
    Scene m_scene = apartment(std::get<0>(GetParam()), std::get<1>(GetParam()));
};

TEST_P(Apartments, NoObjectIsInsideAWallOrAnotherObject)
{
    constexpr float TOUCH = 0.012F;
    for (const auto& object : m_scene.objects())
        for (const auto& point : m_scene.sampleSurface(object.id, 0.05F))
            for (const auto& part : m_scene.parts())
                if (part.object != object.id) {
                    ASSERT_FALSE(part.solid.contains(point.position, TOUCH))
                        << object.category << " " << object.id << " is in "
                        << (part.object == STRUCTURE ? "the walls"
                                                     : m_scene.object(part.object).category)
                        << " " << part.object;
                }
}

TEST_P(Apartments, EverythingStandsOnSomething)
{
    for (const auto& object : m_scene.objects()) {
        if (object.category == "picture") continue;
        const float bottom = object.bounds.min.z;
        if (object.standsOn == STRUCTURE) {
            EXPECT_NEAR(bottom, 0, 0.05F) << object.category;
        } else {
            const Bounds& below = m_scene.object(object.standsOn).bounds;
            EXPECT_GE(bottom, below.min.z - 1e-3F) << object.category;
            EXPECT_LE(bottom, below.max.z + 0.02F) << object.category;
        }
    }
}

TEST_P(Apartments, ObjectsAreInTheRooms)
{
    for (const auto& object : m_scene.objects()) {
        const Bounds& b = object.bounds;
        EXPECT_TRUE(std::any_of(m_scene.rooms().begin(), m_scene.rooms().end(), [&](const Room& r) {
            return b.min.x > r.minX - 0.01F && b.max.x < r.maxX + 0.01F &&
                   b.min.y > r.minY - 0.01F && b.max.y < r.maxY + 0.01F;
        })) << object.category;
    }
}

INSTANTIATE_TEST_SUITE_P(Many, Apartments,
                         ::testing::Combine(::testing::Values(1, 2, 3),
                                            ::testing::Range(uint64_t{1}, uint64_t{9})));

TEST(Apartment, TheFurnitureFitsForEverySeed)
{
    for (const int rooms : {1, 2, 3})
        for (uint64_t seed = 100; seed < 200; ++seed)
            EXPECT_NO_THROW(apartment(rooms, seed)) << rooms << " rooms, seed " << seed;
}

TEST(Apartment, HoldsThePapersNineClasses)
{
    for (const int rooms : {2, 3}) {
        const auto n = counts(apartment(rooms, 4));
        for (const auto* category : {"bed", "chair", "couch", "dining table", "book",
                                     "refrigerator", "tv", "toilet", "backpack"})
            EXPECT_GT(n.count(category), 0U) << rooms << " rooms: " << category;
        EXPECT_GT(n.at("chair"), 2);
    }
}

TEST(Apartment, HasWhatMakesAssociationHard)
{
    int touching = 0, chairsUnderTables = 0, stacked = 0, unknown = 0;
    const auto& known = Recognition::vocabulary();
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        const Scene scene = apartment(2, seed);
        for (const auto& object : scene.objects()) {
            if (object.standsOn != STRUCTURE) ++stacked;
            if (std::find(known.begin(), known.end(), object.category) == known.end()) ++unknown;
            for (const auto id : scene.touching(object.id)) {
                const auto& other = scene.object(id);
                if (other.category == object.category) ++touching;
                const bool under = object.category == "chair" && other.category == "dining table" &&
                                   object.bounds.near(other.bounds, -0.1F);
                if (under) ++chairsUnderTables;
            }
        }
    }
    EXPECT_GT(touching, 12);
    EXPECT_GT(chairsUnderTables, 6);
    EXPECT_GT(stacked, 30);
    EXPECT_GT(unknown, 20);
}

TEST(Apartment, DependsOnTheSeedOnly)
{
    const Scene a = apartment(2, 1), same = apartment(2, 1), other = apartment(2, 2);
    ASSERT_EQ(a.parts().size(), same.parts().size());
    for (size_t i = 0; i < a.parts().size(); ++i)
        EXPECT_EQ(a.parts()[i].solid.bounds().min, same.parts()[i].solid.bounds().min);
    EXPECT_NE(a.rooms().front().maxX, other.rooms().front().maxX);
}
