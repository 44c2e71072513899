// SPDX-License-Identifier: BSD-3-Clause
/** The example that drives to the nearest object, in an apartment whose furniture is known. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "voxeland/simulation/Simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace voxeland;
using namespace voxeland::simulation;
using mrpt::math::TPoint2D;

namespace
{
constexpr double RADIUS = 0.25, REACH = 0.8, ANKLES = 0.1, HEAD = 1.2;  // of the robot [m]
constexpr double VOXEL = 0.05;                                          // [m]

/** What the program printed. */
struct Answer
{
    TPoint2D goal;
    double yaw = 0;
    std::vector<TPoint2D> path;
};

Answer parsed(const std::string& output)
{
    std::istringstream lines(output);
    Answer a;
    std::string word;
    char bracket = 0;
    double degrees = 0;
    lines >> word >> bracket >> a.goal.x >> a.goal.y >> degrees;
    EXPECT_EQ(word, "goal") << output;
    a.yaw = degrees * M_PI / 180;
    std::getline(lines, word);
    for (TPoint2D p; lines >> p.x >> p.y;) a.path.push_back(p);
    return a;
}

/** The apartment, its rawlog and its map, made once. */
class GoTo : public testing::Test
{
 protected:
    static void SetUpTestSuite()
    {
        s_folder = std::make_unique<test::TemporaryFolder>();
        SimulationOptions options;
        options.seed = 5;
        options.camera.frames = 160;
        options.camera.width = 160;
        options.camera.height = 120;
        const Simulator simulator(options);
        s_objects = simulator.scene().objects();
        const std::string rawlog = s_folder->file("apartment.rawlog");
        const auto simulated = test::runProgram(
            "voxeland-simulate", {"-o", rawlog, "--seed", "5", "--frames", "160", "--width", "160",
                                  "--height", "120", "--detector", "perfect", "--exact-depth"});
        ASSERT_EQ(simulated.exitCode, 0) << simulated.errors;
        const auto mapped = test::runProgram("rawlog2voxeland", {"-i", rawlog, "-o", map()});
        ASSERT_EQ(mapped.exitCode, 0) << mapped.errors;
        for (size_t id = 0; id <= s_objects.size(); ++id)
            for (const auto& p : simulator.scene().sampleSurface(static_cast<ObjectId>(id), 0.03F))
                if (p.position.z > ANKLES + VOXEL && p.position.z < HEAD - VOXEL)
                    s_obstacles.emplace_back(p.position.x, p.position.y);
        s_start = openPlace(simulator);
    }
    static void TearDownTestSuite() { s_folder.reset(); }

    [[nodiscard]] static std::string map() { return s_folder->file("apartment.voxeland"); }
    [[nodiscard]] static test::ProgramResult goTo(const std::string& category,
                                                  const TPoint2D& start)
    {
        return test::runProgram(VOXELAND_GO_TO,
                                {map(), category, std::to_string(start.x), std::to_string(start.y),
                                 s_folder->file("way.png")});
    }
    /** Distance to the nearest true surface at the robot's heights [m]. */
    [[nodiscard]] static double clearance(const TPoint2D& at)
    {
        double least = INFINITY;
        for (const TPoint2D& o : s_obstacles) least = std::min(least, (o - at).norm());
        return least;
    }
    /** A place on the camera's way, as late as possible, where the robot surely fits. */
    [[nodiscard]] static TPoint2D openPlace(const Simulator& simulator)
    {
        for (size_t i = simulator.size(); i-- > 0;) {
            const auto pose = simulator.frame(i).truePose;
            if (clearance({pose.x, pose.y}) > RADIUS + 3 * VOXEL) return {pose.x, pose.y};
        }
        throw std::runtime_error("the camera was never in open space");
    }

    static std::unique_ptr<test::TemporaryFolder> s_folder;
    static std::vector<SceneObject> s_objects;
    static std::vector<TPoint2D> s_obstacles;
    static TPoint2D s_start;
};

std::unique_ptr<test::TemporaryFolder> GoTo::s_folder;
std::vector<SceneObject> GoTo::s_objects;
std::vector<TPoint2D> GoTo::s_obstacles;
TPoint2D GoTo::s_start;
}  // namespace

TEST_F(GoTo, EndsBeforeTheObjectAndFacesIt)
{
    for (const std::string category : {"couch", "bed", "refrigerator", "tv"}) {
        const auto result = goTo(category, s_start);
        ASSERT_EQ(result.exitCode, 0) << category << result.errors;
        const Answer answer = parsed(result.output);
        EXPECT_GE(clearance(answer.goal), RADIUS - VOXEL) << category;
        bool faced = false;
        for (const SceneObject& o : s_objects) {
            if (o.category != category) continue;
            const auto middle = o.bounds.center(), half = o.bounds.size() * 0.5F;
            const TPoint2D away(middle.x - answer.goal.x, middle.y - answer.goal.y);
            const TPoint2D gap(std::max(std::abs(away.x) - half.x, 0.0),
                               std::max(std::abs(away.y) - half.y, 0.0));
            const double off = std::atan2(away.y, away.x) - answer.yaw;
            faced = faced || (gap.norm() < REACH + 2 * VOXEL &&
                              std::abs(std::remainder(off, 2 * M_PI)) < 0.35);
        }
        EXPECT_TRUE(faced) << category << ": " << result.output;
        EXPECT_GT(test::readFile(s_folder->file("way.png")).size(), 1000U);
    }
}

TEST_F(GoTo, NothingIsInTheWay)
{
    const Answer answer = parsed(goTo("couch", s_start).output);
    ASSERT_GT(answer.path.size(), 3U);
    EXPECT_NEAR((answer.path.front() - s_start).norm(), 0, 1e-3);
    EXPECT_NEAR((answer.path.back() - answer.goal).norm(), 0, 1e-3);
    for (size_t i = 1; i < answer.path.size(); ++i) {
        const TPoint2D step = answer.path[i] - answer.path[i - 1];
        EXPECT_LT(step.norm(), 0.4);
        for (double t = 0; t <= 1; t += 0.1) {
            const TPoint2D at = answer.path[i - 1] + step * t;
            EXPECT_GE(clearance(at), RADIUS - VOXEL) << at.x << " " << at.y;
        }
    }
}

TEST_F(GoTo, TellsWhatIsWrong)
{
    const auto unknown = goTo("zebra", s_start);
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_NE(unknown.errors.find("no 'zebra' in this map; it holds:"), std::string::npos);
    EXPECT_NE(unknown.errors.find(" couch"), std::string::npos) << unknown.errors;
    const auto outside = goTo("couch", {-50, 0});
    EXPECT_EQ(outside.exitCode, 1);
    EXPECT_NE(outside.errors.find("does not fit where it starts"), std::string::npos);
    const auto beyond = goTo("couch", {1e9, 0});
    EXPECT_EQ(beyond.exitCode, 1);
    EXPECT_NE(beyond.errors.find("out of the map's range"), std::string::npos) << beyond.errors;
    EXPECT_EQ(test::runProgram(VOXELAND_GO_TO, {map(), "couch"}).exitCode, 1);
}
