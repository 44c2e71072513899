// SPDX-License-Identifier: BSD-3-Clause
/** Maps a small simulated rawlog with the policies that go by what the detector says. */
#include "simulation/SimulationRun.h"
#include "support/TestFiles.h"
#include "voxeland/metric_map/RawlogMapping.h"
#include "voxeland/simulation/Simulator.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::simulation;

namespace
{
/** One room seen in few small images, as a rawlog and as the simulator's own word. */
class AssociationOfSimulation : public testing::Test
{
 protected:
    AssociationOfSimulation()
    {
        m_options.scene.rooms = 1;
        m_options.camera.width = 160;
        m_options.camera.height = 120;
        m_options.camera.frames = 24;
        m_options.detector.tracks = true;
        m_options.detector.falseDetections = 1;
        SimulationOutput output;
        output.rawlog = m_folder.file("sim.rawlog");
        runSimulation(m_options, output, [](size_t) {});
    }

    /** Calls f(prediction) for those with a pixel whose depth is used: each must become an
     * opinion. */
    template <typename F>
    void forEachUsablePrediction(F&& f) const
    {
        const Simulator simulator(m_options);
        for (size_t i = 0; i < simulator.size(); ++i) {
            const SimulatedFrame frame = simulator.frame(i);
            for (const InstancePrediction& p : frame.predictions) {
                bool usable = false;
                p.mask.forEachRun([&](uint32_t first, uint32_t last) {
                    for (uint32_t pixel = first; pixel < last; ++pixel)
                        usable |= frame.depth[pixel] >= 500 && frame.depth[pixel] <= 4000;
                });
                if (usable) f(p);
            }
        }
    }

    /** The map of all opinions, none cleaned or left out. */
    [[nodiscard]] SemanticVoxelMap mapWith(const std::string& className) const
    {
        Ini ini;
        for (const auto* assignment :
             {"voxeland.min_depth=0.5", "voxeland.max_depth=4", "converter.ablation=clustering",
              "converter.min_points=1", "converter.min_score=0", "refinement.every=0"})
            ini.set(assignment);
        ini.set("association.class=" + className);
        const MapperConfig config(ini);
        CVoxelandMap map(config);
        RawlogFrameSource source(m_folder.file("sim.rawlog"), config.input, FrameRange());
        mapRawlog(source, map, [](const StageTimes&) {});
        return map.map();
    }

 private:
    SimulationOptions m_options;
    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(AssociationOfSimulation, OneInstanceACategory)
{
    std::map<std::string, uint32_t> expected, found;
    forEachUsablePrediction(
        [&](const InstancePrediction& p) { ++expected[p.categories.front().name]; });
    const auto map = mapWith("CCategoryAssociation");
    for (const auto& [id, instance] : map.instances()) {
        const std::string& name = map.categories().name(instance.categories.sum().top().value());
        EXPECT_EQ(found.count(name), 0U) << "two instances of " << name;
        found[name] = instance.observations;
    }
    EXPECT_GT(found.size(), 4U);
    EXPECT_EQ(found, expected);
}

TEST_F(AssociationOfSimulation, OneInstanceATrackAndOneAnUntrackedOpinion)
{
    std::map<int64_t, uint32_t> expected, found;
    uint32_t expectedUntracked = 0, foundUntracked = 0;
    forEachUsablePrediction([&](const InstancePrediction& p) {
        ++(p.track == InstancePrediction::NO_TRACK ? expectedUntracked : expected[p.track]);
    });
    const auto map = mapWith("CTrackAssociation");
    for (const auto& [id, instance] : map.instances()) {
        if (instance.tracks.empty()) {
            EXPECT_EQ(instance.observations, 1U);
            ++foundUntracked;
            continue;
        }
        EXPECT_EQ(instance.tracks.size(), 1U);
        found[*instance.tracks.begin()] += instance.observations;
    }
    EXPECT_EQ(map.instances().size(), expected.size() + expectedUntracked);
    EXPECT_GT(foundUntracked, 4U);
    EXPECT_EQ(foundUntracked, expectedUntracked);
    EXPECT_GT(found.size(), 4U);
    EXPECT_EQ(found, expected);
}
