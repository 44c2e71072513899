// SPDX-License-Identifier: BSD-3-Clause
#include "HandMadeMap.h"
#include "pipeline/MappingTrace.h"
#include "pipeline/Refinement.h"
#include "support/MapBytes.h"
#include "support/SmallRawlog.h"
#include "voxeland/pipeline/SemanticMapper.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

using namespace voxeland;
using namespace voxeland::test;
using nlohmann::json;

namespace
{
MapperConfig config()
{
    return MapperConfig(
        Ini::fromText("[association]\ntau_iou = 0.375\n"
                      "[refinement]\nevery = 4\nmerge_ios = 0.625\nablation = continuity\n",
                      "the test"));
}

std::vector<json> linesOf(const std::string& text)
{
    std::vector<json> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
    return lines;
}

/** A map of the small rawlog. */
struct SmallMapping
{
    SemanticVoxelMap map;
    MappingCounts counts;

    explicit SmallMapping(const std::shared_ptr<MappingTrace>& trace)
    {
        SemanticMapper mapper(config());
        mapper.setTrace(trace);
        for (const SmallFrame& f : smallFrames(10))
            mapper.integrate(mapper.prepare({f.scan, f.instances, f.pose->pose.mean}), map, counts);
    }
};
}  // namespace

TEST(MappingTrace, TellsOfEveryOpinionAndChangesNothing)
{
    std::ostringstream out;
    const SmallMapping traced(std::make_shared<MappingTrace>(out, config())), silent(nullptr);
    EXPECT_EQ(bytesOf(traced.map), bytesOf(silent.map));

    const auto lines = linesOf(out.str());
    ASSERT_FALSE(lines.empty());
    const json& thresholds = lines[0].at("thresholds");
    EXPECT_EQ(thresholds.at("association").at("tau_iou"), 0.375);
    EXPECT_EQ(thresholds.at("association").at("class"), "CEvidentialAssociation");
    EXPECT_EQ(thresholds.at("refinement").at("merge_ios"), 0.625);
    EXPECT_EQ(thresholds.at("refinement").at("ablation"), "continuity");

    uint32_t opinions = 0;
    std::set<instance_id_t> created;
    for (const json& line : lines) {
        if (!line.contains("opinion")) continue;
        EXPECT_EQ(line.at("frame"), opinions / 2) << "two opinions a frame";
        EXPECT_EQ(line.at("opinion"), opinions % 2);
        EXPECT_EQ(line.at("category"), opinions % 2 == 1         ? "picture"
                                       : (opinions / 2) % 3 == 0 ? "box"
                                                                 : "tv");
        const instance_id_t assigned = line.at("assigned");
        EXPECT_EQ(created.insert(assigned).second, line.at("new").get<bool>());
        bool isCandidate = false;
        for (const json& candidate : line.at("candidates")) {
            isCandidate = isCandidate || candidate.at("instance") == assigned;
            for (const char* ratio : {"iou", "iov", "iom", "touched", "similarity"}) {
                EXPECT_GE(candidate.at(ratio), 0) << ratio;
                EXPECT_LE(candidate.at(ratio), 1 + 1e-9) << ratio;
            }
        }
        EXPECT_NE(isCandidate, line.at("new").get<bool>());
        ++opinions;
    }
    EXPECT_EQ(opinions, traced.counts.opinions);
    EXPECT_EQ(opinions, 20U);
}

TEST(MappingTrace, TellsOfEveryDivisionAndPair)
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t apart = addInstance(map, "chair");  // 1: three parts, one too small
    addBox(map, apart, {0, 0, 0}, {5, 5, 5});
    addBox(map, apart, {12, 0, 0}, {4, 4, 4});
    addBox(map, apart, {0, 12, 0}, {2, 2, 2});
    const instance_id_t large = addInstance(map, "sofa");  // 2 and 3: one object
    const instance_id_t small = addInstance(map, "sofa");
    addBox(map, large, {0, 40, 0}, {10, 4, 4});
    addBox(map, small, {7, 40, 0}, {4, 4, 4});
    const instance_id_t cup = addInstance(map, "cup");  // 4: on the sofa
    addBox(map, cup, {0, 40, 0}, {2, 2, 2});
    const instance_id_t left = addInstance(map, "tv");  // 5 and 6: shared but not connected
    const instance_id_t right = addInstance(map, "tv");
    addBox(map, left, {0, 80, 0}, {5, 5, 5});
    addBox(map, left, {20, 80, 0}, {4, 4, 4}, 1);
    addBox(map, right, {20, 80, 0}, {4, 4, 4}, 2);

    std::ostringstream out;
    MappingTrace trace(out, config());
    MappingCounts counts;
    refine(map, *evidentialPolicy(), handMadeRefinement(), 0, true, counts, &trace);
    EXPECT_EQ(counts.splits, 1U);
    EXPECT_EQ(counts.merges, 1U);

    const auto lines = linesOf(out.str());
    ASSERT_EQ(lines.size(), 5U);
    const json& division = lines[1];
    EXPECT_EQ(division.at("divided"), apart);
    EXPECT_EQ(division.at("least"), 19) << "a tenth of 197 voxels";
    EXPECT_EQ(division.at("parts"), json::parse(R"([{"voxels":125,"instance":1},
        {"voxels":64,"instance":7},{"voxels":8,"instance":null}])"));

    const auto pairLine = [&](instance_id_t a, instance_id_t b) {
        for (const json& line : lines)
            if (line.contains("pair") && line["pair"] == json::array({a, b})) return line;
        ADD_FAILURE() << "no line about " << a << " and " << b;
        return json();
    };
    const json merged = pairLine(large, small);
    EXPECT_EQ(merged.at("decision"), "merged");
    EXPECT_EQ(merged.at("connected"), true);
    EXPECT_DOUBLE_EQ(merged.at("ios"), 0.75);
    EXPECT_DOUBLE_EQ(merged.at("iou"), 3.0 / 11);
    EXPECT_EQ(merged.at("voxels"), json::array({160, 64}));
    EXPECT_NEAR(merged.at("similarity"), 1, 1e-9);
    EXPECT_EQ(pairLine(large, cup).at("decision"), "refused");
    EXPECT_EQ(pairLine(large, cup).at("connected"), nullptr);
    EXPECT_EQ(pairLine(left, right).at("decision"), "apart");
    EXPECT_EQ(pairLine(left, right).at("connected"), false);
}
