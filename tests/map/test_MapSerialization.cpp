// SPDX-License-Identifier: BSD-3-Clause
#include "MapBuilding.h"
#include "support/MapBytes.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

using namespace voxeland;
using test::bytesOf;

namespace
{
SemanticVoxelMap mapFrom(const std::string& bytes)
{
    mrpt::io::CMemoryStream stream;
    stream.Write(bytes.data(), bytes.size());
    stream.Seek(0);
    auto archive = mrpt::serialization::archiveFrom(stream);
    SemanticVoxelMap map;
    map.readFrom(archive);
    return map;
}

/** A map with a history: merges, splits, a deactivation, more than four instances in a voxel. */
SemanticVoxelMap eventfulMap()
{
    MapOptions options;
    options.resolution = 0.07;
    options.prior_strength = 1.5;
    options.entropy = EntropyMeasure::paper;
    options.occupancy.prob_hit = 0.8;
    SemanticVoxelMap map(options);
    std::mt19937 random(41);
    for (int i = 0; i < 3000; ++i) test::changeAtRandom(map, random);
    for (int i = 0; i < 9; ++i) map.addEvidence({3, 3, 3}, map.createInstance().id, 0.125F);
    map.instance(test::liveIds(map).back()).tracks = {-5, 3};
    for (int cell = 0; cell < BLOCK_CELLS; cell += 3)
        map.blocks().at({-7, 2, 0}).setOccupancy(cell, static_cast<log_odds_t>(cell - 200));
    return map;
}
template <typename Number>
std::string bytesOf(Number number)
{
    return {reinterpret_cast<const char*>(&number), sizeof(number)};
}

/** What a map says that is read from bytes in which `from`, found once, was replaced. */
std::string refusal(std::string bytes, const std::string& from, const std::string& to)
{
    const size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(bytes.find(from, at + 1), std::string::npos);
    bytes.replace(at, from.size(), to);
    try {
        mapFrom(bytes);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "accepted";
}
}  // namespace

TEST(MapSerialization, ReadingAndWritingAgainGivesTheSameBytes)
{
    const std::string once = bytesOf(eventfulMap());
    EXPECT_EQ(bytesOf(mapFrom(once)), once);
    EXPECT_EQ(bytesOf(mapFrom(bytesOf(SemanticVoxelMap()))), bytesOf(SemanticVoxelMap()));
}

TEST(MapSerialization, ReadsBackWhatWasWritten)
{
    const SemanticVoxelMap map = eventfulMap(), read = mapFrom(bytesOf(map));
    EXPECT_EQ(read.options().resolution, 0.07);
    EXPECT_EQ(read.options().prior_strength, 1.5);
    EXPECT_EQ(read.options().entropy, EntropyMeasure::paper);
    EXPECT_EQ(read.options().occupancy.prob_hit, 0.8);
    EXPECT_EQ(read.categories().names(), map.categories().names());
    EXPECT_EQ(read.evidence({3, 3, 3})->size(), map.evidence({3, 3, 3})->size());
    EXPECT_EQ(read.occupancy(voxelAt({-7, 2, 0}, 300)), 100);
    EXPECT_EQ(read.occupancy(voxelAt({-7, 2, 0}, 301)), UNOBSERVED);
    ASSERT_EQ(test::liveIds(read), test::liveIds(map));
    for (const auto& [id, instance] : map.instances()) {
        EXPECT_EQ(read.instance(id).voxels, instance.voxels);
        EXPECT_EQ(read.instance(id).observations, instance.observations);
        EXPECT_EQ(read.instance(id).tracks, instance.tracks);
        EXPECT_EQ(read.instance(id).blocks, instance.blocks);
        EXPECT_EQ(read.instance(id).categories.sum().total(), instance.categories.sum().total());
        EXPECT_EQ(read.instance(id).evidence().total(), instance.evidence().total());
        EXPECT_EQ(read.instance(id).views.byCategory().size(), instance.views.byCategory().size());
        EXPECT_EQ(read.instance(id).history.size(), instance.history.size());
        EXPECT_EQ(read.instance(id).decisions.size(), instance.decisions.size());
    }
    for (instance_id_t id = 1; id < 400; ++id) EXPECT_EQ(read.resolve(id), map.resolve(id));
}

TEST(MapSerialization, MappingGoesOnAsIfNothingHadHappened)
{
    SemanticVoxelMap straight = eventfulMap(), resumed = mapFrom(bytesOf(straight));
    std::mt19937 randomA(42), randomB(42);
    for (int i = 0; i < 1000; ++i) {
        test::changeAtRandom(straight, randomA);
        test::changeAtRandom(resumed, randomB);
    }
    EXPECT_EQ(bytesOf(straight), bytesOf(resumed));
}

TEST(MapSerialization, ContentDecidesTheBytesNotTheOrderOfBlocks)
{
    SemanticVoxelMap a, b;
    const std::vector<VoxelCoord> voxels = {{0, 0, 0}, {100, -3, 2}, {-50, 0, 9}};
    for (auto v = voxels.begin(); v != voxels.end(); ++v) a.addEvidence(*v, 0, 1);
    for (auto v = voxels.rbegin(); v != voxels.rend(); ++v) b.addEvidence(*v, 0, 1);
    EXPECT_EQ(bytesOf(a), bytesOf(b));
}

TEST(MapSerialization, CutOrForeignBytesAreRefused)
{
    const std::string bytes = bytesOf(eventfulMap());
    for (const size_t length :
         {size_t{0}, size_t{1}, size_t{40}, bytes.size() / 2, bytes.size() - 8})
        EXPECT_ANY_THROW(mapFrom(bytes.substr(0, length))) << length;
    std::string newer = bytes;
    newer[0] = 99;
    EXPECT_THROW(mapFrom(newer), std::runtime_error);
}

TEST(MapSerialization, ImpossibleContentIsRefused)
{
    constexpr float ALPHA = 1.2345F;
    constexpr double BETA = 0.123456789;
    SemanticVoxelMap map;
    map.categories().add("chair");
    Instance& chair = map.createInstance();
    CategoryEvidence sum, ofNoSide;
    sum.add(0, BETA);
    ofNoSide.add(0, 2 * BETA);  // so that the number is written once
    chair.categories = CategoryOpinions::restored(sum, ofNoSide, {});
    map.addEvidence({1, 2, 3}, chair.id, ALPHA);
    const std::string bytes = bytesOf(map), corrupt = "corrupt map: ";

    for (const float alpha : {0.0F, -1.0F, std::nanf(""), INFINITY})
        EXPECT_EQ(refusal(bytes, bytesOf(ALPHA), bytesOf(alpha)).find(corrupt), 0U) << alpha;
    for (const double beta : {0.0, -1.0, std::nan(""), double{INFINITY}})
        EXPECT_EQ(refusal(bytes, bytesOf(BETA), bytesOf(beta)).find(corrupt), 0U) << beta;
    EXPECT_NE(refusal(bytes, bytesOf(category_id_t{0}) + bytesOf(BETA),
                      bytesOf(category_id_t{1}) + bytesOf(BETA))
                  .find("category"),
              std::string::npos);
    EXPECT_NE(refusal(bytes, bytesOf(chair.id) + bytesOf(ALPHA),
                      bytesOf(instance_id_t{2}) + bytesOf(ALPHA))
                  .find("instance"),
              std::string::npos);
    EXPECT_EQ(refusal(bytes, bytesOf(ALPHA), bytesOf(2 * ALPHA)), "accepted");
}

TEST(MapSerialization, OpinionsOfMapsBeforeTheFourthVersionCountFully)
{
    constexpr double BETA = 12.3456789;
    SemanticVoxelMap map;
    map.categories().add("chair");
    map.createInstance().categories.add(0, BETA);
    std::string bytes = bytesOf(map);
    const std::string opinions = bytesOf(uint32_t{1}) + bytesOf(category_id_t{0}) + bytesOf(BETA);
    const std::string now = opinions + opinions + bytesOf(uint32_t{0});
    ASSERT_NE(bytes.find(now), std::string::npos);
    bytes.replace(bytes.find(now), now.size(), opinions);
    const std::string calibration = bytesOf(1.0) + bytesOf(uint32_t{0});
    bytes.erase(bytes.find(calibration), calibration.size());
    bytes[0] = 3;
    const SemanticVoxelMap read = mapFrom(bytes);
    EXPECT_EQ(read.instance(1).evidence().betaOf(0), BETA);
    EXPECT_EQ(bytesOf(read), bytesOf(map));
}

TEST(MapSerialization, OpinionsOfImpossibleSidesAreRefused)
{
    constexpr double BETA = 12.3456789;
    SemanticVoxelMap map;
    CategoryEvidence opinion;
    opinion.add(map.categories().add("chair"), BETA);
    map.createInstance().categories.add(opinion, side_t{0x123});
    const std::string bytes = bytesOf(map), side = bytesOf(side_t{0x123}) + bytesOf(1.0);
    EXPECT_EQ(refusal(bytes, side, bytesOf(SIDES) + bytesOf(1.0)).find("corrupt map: "), 0U);
    EXPECT_EQ(refusal(bytes, side, bytesOf(side_t{0x123}) + bytesOf(-1.0)).find("corrupt map: "),
              0U);
    EXPECT_EQ(refusal(bytes, side, bytesOf(side_t{0x124}) + bytesOf(2.0)), "accepted");
}

TEST(MapSerialization, ImpossibleMergesAreRefused)
{
    SemanticVoxelMap map;
    for (int i = 0; i < 0x1234; ++i) map.createInstance();
    map.merge(0x1233, 0x1234, 0);
    map.instance(0x1233).history.clear();  // where the two numbers would stand once more
    const auto pair = [](instance_id_t a, instance_id_t b) { return bytesOf(a) + bytesOf(b); };
    const std::string bytes = bytesOf(map), merge = pair(0x1234, 0x1233), corrupt = "corrupt map: ";
    EXPECT_EQ(refusal(bytes, merge, pair(0x1233, 0x1233)).find(corrupt), 0U) << "with itself";
    EXPECT_EQ(refusal(bytes, merge, pair(0x1235, 0x1233)).find(corrupt), 0U) << "of no instance";
    EXPECT_EQ(refusal(bytes, merge, pair(0x1234, 0x1235)).find(corrupt), 0U) << "with no instance";
    EXPECT_EQ(refusal(bytes, merge, pair(0x1232, 0x1233)).find(corrupt), 0U) << "of a live one";
    EXPECT_EQ(refusal(bytes, merge, pair(0x1234, 0x1232)), "accepted");
}

TEST(MapSerialization, MergesInACircleAreRefused)
{
    SemanticVoxelMap map;
    for (int i = 0; i < 0x1236; ++i) map.createInstance();
    map.merge(0x1235, 0x1234, 0);
    map.merge(0x1236, 0x1235, 0);
    map.instance(0x1236).history.clear();
    const auto pair = [](instance_id_t a, instance_id_t b) { return bytesOf(a) + bytesOf(b); };
    const std::string bytes = bytesOf(map);
    EXPECT_EQ(refusal(bytes, pair(0x1235, 0x1236), pair(0x1235, 0x1234)).find("corrupt map: "), 0U);
}

TEST(MapSerialization, BlocksBeyondTheCoordinatesAreRefused)
{
    SemanticVoxelMap map;
    map.addEvidence({8 * 0x1234, 0, 0}, UNKNOWN_INSTANCE, 1);
    const std::string bytes = bytesOf(map), at = bytesOf(int32_t{0x1234});
    constexpr int32_t MOST = MAX_VOXEL_COORD / BLOCK_SIDE;
    for (const int32_t far : {MOST + 1, -MOST - 2, INT32_MAX, INT32_MIN})
        EXPECT_EQ(refusal(bytes, at, bytesOf(far)).find("corrupt map: "), 0U) << far;
    EXPECT_EQ(refusal(bytes, at, bytesOf(-MOST - 1)), "accepted") << "some of its voxels fit";
}

TEST(MapSerialization, WhatIsNoEvidenceIsNeverWritten)
{
    constexpr float INF = std::numeric_limits<float>::infinity();
    SemanticVoxelMap map;
    map.categories().add("chair");
    const instance_id_t id = map.createInstance().id;
    map.instance(id).decisions.resize(1);
    map.instance(id).decisions[0].evidence = std::numeric_limits<double>::denorm_min();
    map.addEvidence({0, 0, 0}, id, 1);
    map.addEvidence({9, 0, 0}, id, 1);
    for (const float none : {0.0F, -1.0F, INF, std::nanf("")}) map.addEvidence({1, 0, 0}, id, none);
    map.split(id, {{9, 0, 0}}, 0.25, 3);  // a quarter of the least number there is: nothing
    const SemanticVoxelMap read = mapFrom(bytesOf(map));
    EXPECT_EQ(read.evidence({1, 0, 0}), nullptr);
    EXPECT_TRUE(read.instance(2).decisions.empty());
}

TEST(MapSerialization, AbsorbedInstancesThatLeadInACircleAreRefused)
{
    SemanticVoxelMap map;
    for (int i = 0; i < 4; ++i) map.addEvidence({i, 0, 0}, map.createInstance().id, 1);
    map.merge(2, 1, 0);
    map.merge(4, 3, 0);
    const std::string bytes = bytesOf(map);
    const auto pairs = [](std::array<uint32_t, 4> ids) {
        std::string text;
        for (const uint32_t id : ids) text += bytesOf(id);
        return text;
    };
    const std::string written = pairs({1, 2, 3, 4});
    EXPECT_EQ(refusal(bytes, written, written), "accepted");
    EXPECT_EQ(refusal(bytes, written, pairs({1, 3, 3, 1})), "corrupt map: an impossible merge");
    EXPECT_EQ(refusal(bytes, written, pairs({1, 1, 3, 4})), "corrupt map: an impossible merge");
    EXPECT_EQ(refusal(bytes, written, pairs({1, 0xFFFFFFFF, 3, 4})),
              "corrupt map: a merge with an instance it lacks");
}

TEST(MapSerialization, ATruthMayBeAnyByte)
{
    SemanticVoxelMap map;
    map.categories().add("chair");
    InstanceView view;
    view.area = 0x12345678;
    view.truncated = true;
    view.score = view.probability = 1;
    map.createInstance().views.add(0, view, 1);
    const std::string bytes = bytesOf(map);
    const size_t truth = bytes.find(bytesOf(view.area)) + sizeof(view.area);
    for (const int byte : {1, 2, 0x80, 0xFF}) {
        std::string odd = bytes;
        odd.at(truth) = static_cast<char>(byte);
        const SemanticVoxelMap read = mapFrom(odd);
        EXPECT_EQ(bytesOf(read), bytes) << byte;
        EXPECT_EQ(read.instance(1).views.of(0).at(0).quality(), view.quality()) << byte;
    }
}

TEST(MapSerialization, TheLastIdIsNotPassed)
{
    SemanticVoxelMap map;
    map.addEvidence({0, 0, 0}, map.createInstance().id, 1);
    std::string bytes = bytesOf(map);
    const std::string next = bytesOf(uint32_t{2});
    size_t full = 0;
    for (size_t at = bytes.find(next); at != std::string::npos; at = bytes.find(next, at + 1)) {
        std::string changed = bytes;
        changed.replace(at, next.size(), bytesOf(uint32_t{0xFFFFFFFF}));
        try {
            mapFrom(changed).createInstance();
        } catch (const InputError&) {
            ++full;
        } catch (const std::runtime_error&) {  // it was another number that is 2
        }
    }
    EXPECT_EQ(full, 1U);
}
