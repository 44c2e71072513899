// SPDX-License-Identifier: BSD-3-Clause
/** Whatever numbers come in: a map that was written can be read. */
#include "disambiguation/Decisions.h"
#include "support/MapBytes.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/MapFile.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace voxeland;
using mrpt::poses::CPose3D;

namespace
{
using Limits = std::numeric_limits<double>;
constexpr double INF = Limits::infinity(), NONE = Limits::quiet_NaN();

/** Makes frames whose numbers are mostly fine and now and then anything. */
class AnyFrames
{
 public:
    explicit AnyFrames(unsigned seed) : m_random(seed) {}

    template <typename Number>
    Number oneOf(std::initializer_list<Number> numbers)
    {
        return numbers.begin()[m_random() % numbers.size()];
    }

    MapperConfig config()
    {
        Ini ini = Ini::fromText("", "test");
        const auto set = [&](const std::string& key, std::initializer_list<const char*> values) {
            ini.set(key + "=" + oneOf(values), "test");
        };
        set("map.resolution", {"0.05", "0.05", "0.02", "0.001", "1"});
        set("voxeland.min_depth", {"0"});
        set("map.pose_uncertainty", {"true", "true", "false"});
        set("map.unknown_weight", {"1", "0.1", "0"});
        set("map.sharpness", {"1", "2", "100"});
        set("map.prior_strength", {"2", "0", "1e30", "1e308"});
        set("map.views_kept", {"8", "1", "0"});
        set("refinement.every", {"1", "2"});
        return MapperConfig(ini);
    }

    std::vector<test::SmallFrame> frames(double resolution)
    {
        m_edge = resolution * MAX_VOXEL_COORD;
        auto frames = test::smallFrames(4);
        const CPose3D place(coordinate(), coordinate(), coordinate());
        for (auto& f : frames) {
            f.pose->pose.mean = place + f.pose->pose.mean;
            f.scan->rangeUnits *= std::min(1.F, static_cast<float>(resolution / 0.02));
            if (odd()) f.pose->pose.mean = CPose3D(coordinate(), coordinate(), 0);
            if (odd())
                f.pose->pose.mean =
                    CPose3D(number(), number(), number(), angle(), angle(), angle());
            if (odd()) f.pose->pose.cov.setDiagonal(variance());
            if (odd()) f.pose->pose.cov(0, 4) = f.pose->pose.cov(4, 0) = number();
            if (odd()) f.scan->sensorPose = CPose3D(number(), 0, 0, angle(), 0, 0);
            if (odd())
                f.scan->rangeUnits = oneOf({1e-9F, 1.F, 100.F, 1e30F, float(INF), float(NONE)});
            if (odd()) f.scan->cameraParams.fx(oneOf({1e9, -40.0, INF, NONE}));
            if (odd())
                f.instances->timestamp = f.scan->timestamp =
                    oneOf({mrpt::Clock::time_point(), mrpt::Clock::time_point::max(),
                           mrpt::Clock::time_point::min()});
            for (auto& i : f.instances->instances) {
                if (odd()) i.score = score();
                if (odd()) i.categories = {{"box", score()}, {"", score()}, {"tv", score()}};
                if (odd()) i.categories.clear();
                if (odd()) i.mask = test::rectangleMask(0, 0, 9, 9, 10, 10);
            }
        }
        return frames;
    }

    /** Answers about the same objects, again and again. */
    void decideOften(SemanticVoxelMap& map)
    {
        DisambiguationOptions options;
        options.answer_reliability = 0.999;
        for (const auto& [id, instance] : map.instances())
            for (int n = oneOf({0, 1, 60}); n > 0; --n) decide(map, id, {}, options);
    }

 private:
    bool odd() { return m_random() % 12 == 0; }
    float score()
    {
        return oneOf({0.5F, 1.F, 1e-45F, 1.0000001F, 2.F, -1.F, 1e38F, float(INF), float(NONE)});
    }
    double angle() { return oneOf({0.0, 1.0, 1e9, INF, NONE}); }
    double variance()
    {
        return oneOf({0.0, 1e-300, 1e-4, 1.0, 1e30, 1e300, 1.7e308, -1.0, INF, NONE});
    }
    double number() { return oneOf({0.0, 1e3, -1e6, 1e9, 1e15, 1e200, -1e308, INF, NONE}); }
    /** Most often where a map ends, or would if its origin were that of the world. */
    double coordinate()
    {
        const double offset = std::uniform_real_distribution(-4.0, 4.0)(m_random);
        return oneOf({0.0, 0.0, m_edge / 2 + offset, m_edge - 2 + offset, -m_edge + offset, 9.9e8});
    }

    std::mt19937 m_random;
    double m_edge = 0;
};

/** As MRPT's programs fill a map; frames that cannot be used are left out, some still wait. */
void insert(CVoxelandMap& map, const std::vector<test::SmallFrame>& frames)
{
    for (const auto& f : frames) {
        try {
            map.insertObservation(*f.scan, f.pose->pose.mean);
            map.insertObservation(*f.instances, f.pose->pose.mean);
        } catch (const InputError&) {
        }
    }
}

/** As rawlog2voxeland does. */
void mapThrough(const std::string& rawlog, CVoxelandMap& map,
                const std::vector<test::SmallFrame>& frames)
{
    test::writeRawlog(rawlog, frames);
    try {
        RawlogFrameSource source(rawlog, map.mapper().config().input, {});
        mapRawlog(source, map, [](const StageTimes&) {});
    } catch (const InputError&) {
    } catch (const NothingToMapError&) {
    }
}
}  // namespace

TEST(ExtremeInputs, whatWasWrittenCanBeRead)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("a.voxeland");
    unsigned written = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        AnyFrames any(seed);
        CVoxelandMap map(any.config());
        const auto frames = any.frames(map.map().resolution());
        if (seed % 2 == 0)
            insert(map, frames);
        else
            mapThrough(folder.file("r.rawlog"), map, frames);
        any.decideOften(map.editMap());
        saveMap(map, file);
        ASSERT_NO_THROW({
            const auto again = loadMap(file);
            EXPECT_EQ(test::bytesOf(again->map()), test::bytesOf(map.map()));
            written += again->map().empty() ? 0U : 1U;
        });
    }
    EXPECT_GT(written, 20U);
}
