// SPDX-License-Identifier: BSD-3-Clause
/** MRPT's pf-localization finds a robot in a Voxeland map. */
#include "SimulatedRobot.h"

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
class MrptLocalization : public SimulatedRobot, public testing::WithParamInterface<Way>
{
 protected:
    /** Runs pf-localization with the shipped INI, which loads robot.voxeland. The heading is known
     * to half a turn: pf-localization has no seed, and in one run of fifty the other half wins.
     *  \return mean distance of the particles to the truth, for each step [m] */
    std::vector<double> localize(const std::string& rawlog)
    {
        writeTruth();
        std::string ini = readFile(mrptConfig("pf-localization.ini"));
        const double heading = mrpt::RAD2DEG(truth("robot").at(0).phi);
        // Of two lines with the same key the last one holds.
        ini.insert(ini.find("\n3DSceneFrequency"),
                   "\nground_truth_path_file = truth.txt\ninit_PDF_min_yaw_deg = " +
                       std::to_string(heading - 90) +
                       "\ninit_PDF_max_yaw_deg = " + std::to_string(heading + 90) + "\n");
        writeFile(path("pf.ini"), ini);
        const auto result =
            runMrpt(GetParam(), folder(), "pf-localization", {path("pf.ini"), rawlog});
        EXPECT_EQ(result.exitCode, 0) << result.output << result.errors;
        std::ifstream in(path("pf-localization-out_000_0010000/GT_error.txt"));
        std::vector<double> errors;
        for (double error = 0; in >> error;) errors.push_back(error);
        return errors;
    }

    /** A map of every second frame, as robot.voxeland. */
    void makeMap(const std::string& rawlog)
    {
        const auto result =
            runProgram("rawlog2voxeland",
                       {"-i", rawlog, "-o", path("robot.voxeland"), "--every", "2", "--quiet"});
        ASSERT_EQ(result.exitCode, 0) << result.errors;
    }

 private:
    /** The true way in MRPT's format: time, x, y, angle. */
    void writeTruth()
    {
        std::ifstream in(path("robot_truth/trajectory.tum"));
        std::ostringstream out;
        std::string line, time;
        // MRPT takes a first column that begins with an integer for numbers of entries.
        std::getline(in, line);
        const auto poses = truth("robot");
        for (size_t i = 1; i < poses.size() && in >> time && std::getline(in, line); ++i)
            out << time << " " << poses[i].x << " " << poses[i].y << " " << poses[i].phi << "\n";
        writeFile(path("truth.txt"), out.str());
    }
};
}  // namespace

TEST_P(MrptLocalization, TheRobotIsFoundAnywhereInTheRoom)
{
    SKIP_WITHOUT("pf-localization");
    const auto rawlog = simulate("robot", 60, {"--embed", "--images", "embedded"});
    makeMap(rawlog);
    const auto errors = localize(rawlog);
    ASSERT_GT(errors.size(), 100U);
    const double worstLater = *std::max_element(errors.begin() + 50, errors.end());
    RecordProperty("largest_error_mm", static_cast<int>(1000 * worstLater));
    EXPECT_LT(worstLater, 0.15);
}

TEST_P(MrptLocalization, OfSensoryFramesToo)
{
    SKIP_WITHOUT("pf-localization");
    const auto rawlog =
        simulate("robot", 60, {"--embed", "--images", "embedded", "--sensory-frames"});
    makeMap(rawlog);
    const auto errors = localize(rawlog);
    ASSERT_GT(errors.size(), 50U);
    EXPECT_LT(*std::max_element(errors.end() - 20, errors.end()), 0.15);
}

INSTANTIATE_TEST_SUITE_P(Ways, MrptLocalization, testing::Values(Way::Preload, Way::Launcher),
                         [](const auto& way) { return nameOf(way.param); });

using MrptLocalizationErrors = SimulatedRobot;

TEST_F(MrptLocalizationErrors, AMapThatIsNotThereIsTold)
{
    const auto rawlog = simulate("robot", 2, {"--embed", "--images", "embedded"});
    const auto result = runMrpt(Way::Launcher, folder(), "pf-localization",
                                {mrptConfig("pf-localization.ini"), rawlog});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.errors.find("robot.voxeland"), std::string::npos) << result.errors;
}
