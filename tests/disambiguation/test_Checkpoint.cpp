// SPDX-License-Identifier: BSD-3-Clause
/** Answers in an output of an earlier run. */
#include "disambiguation/Checkpoint.h"
#include "disambiguation/Decisions.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** A map with one instance, and maybe a decision about it. */
void fill(CVoxelandMap& map, bool decided)
{
    SemanticVoxelMap& voxels = map.editMap();
    Instance& instance = voxels.createInstance();
    Decision decision;
    decision.category = voxels.categories().add("chair");
    decision.answer = "a chair";
    instance.categories.add(decision.category, 2);
    if (decided) decide(voxels, instance.id, decision, {});
}
}  // namespace

TEST(Checkpoint, TakesOverWhatAnEarlierRunDecidedOfTheSameMap)
{
    const TemporaryFolder folder;
    CVoxelandMap map, decided;
    fill(map, false);
    fill(decided, true);
    saveMap(decided, folder.file("out.voxeland"));
    EXPECT_EQ(takeOverDecisions(map, folder.file("out.voxeland")), 1U);
    EXPECT_EQ(map.map().instance(1).decisions.size(), 1U);
    EXPECT_EQ(takeOverDecisions(map, folder.file("absent.voxeland")), 0U);
}

TEST(Checkpoint, AMapThatCannotBeReadIsNoReasonToAskForItsAnswersAgain)
{
    const TemporaryFolder folder;
    CVoxelandMap map, decided;
    fill(map, false);
    fill(decided, true);
    const std::string file = folder.file("out.voxeland");
    saveMap(decided, file);
    const std::string whole = readFile(file);
    writeFile(file, whole.substr(0, whole.size() / 2));
    EXPECT_THROW(static_cast<void>(takeOverDecisions(map, file)), InputError);
    writeFile(file, "notes of mine");
    EXPECT_EQ(takeOverDecisions(map, file), 0U) << "no map: whoever named it wants it replaced";
}
