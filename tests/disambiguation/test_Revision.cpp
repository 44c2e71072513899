// SPDX-License-Identifier: BSD-3-Clause
#include "UncertainMap.h"
#include "disambiguation/Decisions.h"
#include "disambiguation/Revision.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
constexpr category_id_t CHAIR = 0, COUCH = 1;

Decision by(const std::string& source, category_id_t category, const std::string& answer)
{
    Decision d;
    d.source = source;
    d.category = category;
    d.answer = answer;
    return d;
}
}  // namespace

TEST(Revision, AnotherAnswerReplacesWhatTheSameBackEndSaidSince)
{
    SemanticVoxelMap map;
    const instance_id_t id = test::addInstance(map, 3, 2, 0);
    decide(map, id, by("person", COUCH, "couch"), {});
    const Revision revision(map, "person");
    decide(map, id, by("model", COUCH, "couch"), {});
    SemanticVoxelMap withoutChair = map;
    decide(withoutChair, id, by("person", COUCH, "a couch"), {});
    const double expected = withoutChair.instance(id).decisions[2].evidence;
    decide(map, id, by("person", CHAIR, "chair"), {});

    revision.decide(map, id, by("person", CHAIR, "chair"), {});
    ASSERT_EQ(map.instance(id).decisions.size(), 3U) << "nothing new";
    revision.decide(map, id, by("person", COUCH, "a couch"), {});
    const auto& decisions = map.instance(id).decisions;
    ASSERT_EQ(decisions.size(), 3U);
    EXPECT_EQ(decisions[0].answer, "couch") << "said before";
    EXPECT_EQ(decisions[1].source, "model");
    EXPECT_EQ(decisions[2].answer, "a couch");
    EXPECT_DOUBLE_EQ(decisions[2].evidence, expected) << "what it replaces is no evidence";
}

TEST(Revision, WhatIsWithdrawnIsOnlyWhatTheBackEndSaidSince)
{
    SemanticVoxelMap map;
    const instance_id_t a = test::addInstance(map, 3, 2, 0), b = test::addInstance(map, 1, 2, 0);
    decide(map, a, by("person", COUCH, "couch"), {});
    const Revision revision(map, "person");
    decide(map, a, by("person", CHAIR, "chair"), {});
    decide(map, b, by("person", CHAIR, "chair"), {});
    decide(map, b, by("model", CHAIR, "chair"), {});
    EXPECT_EQ(revision.withdraw(map), 2U);
    EXPECT_EQ(map.instance(a).decisions.size(), 1U);
    ASSERT_EQ(map.instance(b).decisions.size(), 1U);
    EXPECT_EQ(map.instance(b).decisions[0].source, "model");
    EXPECT_EQ(revision.withdraw(map), 0U);
}
