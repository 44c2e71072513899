// SPDX-License-Identifier: BSD-3-Clause
#include "SimulatedRobot.h"

#include "files/GzInputFile.h"
#include "files/GzOutputFile.h"
#include "support/MapBytes.h"
#include "voxeland/metric_map/MapFile.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>
#include <fstream>

using namespace mrpt::obs;
namespace fs = std::filesystem;

namespace voxeland::test
{
std::string nameOf(Way way)
{
    return way == Way::Preload ? "Preload" : "Launcher";
}

ProgramResult runMrpt(Way way, const std::string& folder, const std::string& program,
                      const std::vector<std::string>& arguments)
{
    std::vector<std::string> all{program};
    all.insert(all.end(), arguments.begin(), arguments.end());
    if (way == Way::Launcher) return runProgramIn(folder, "voxeland-run", all);
    all.insert(all.begin(), "LD_PRELOAD=" + voxelandLibrary());
    return runProgramIn(folder, "env", all);
}

std::string voxelandLibrary()
{
    return std::string(VOXELAND_TEST_BINARY_DIR) + "/lib/libvoxeland.so";
}

bool isInstalled(const std::string& program)
{
    return runProgram("which", {program}).exitCode == 0;
}

std::string mrptConfig(const std::string& name)
{
    return std::string(VOXELAND_MRPT_CONFIG) + "/" + name;
}

std::string SimulatedRobot::simulate(const std::string& name, int frames,
                                     const std::vector<std::string>& options)
{
    std::vector<std::string> all{"-o",       path(name + ".rawlog"),
                                 "--gt",     path(name + "_truth"),
                                 "--frames", std::to_string(frames),
                                 "--robot",  "--rooms",
                                 "1",        "--width",
                                 "160",      "--height",
                                 "120",      "--quiet"};
    all.insert(all.end(), options.begin(), options.end());
    const auto result = runProgram("voxeland-simulate", all);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return path(name + ".rawlog");
}

std::string SimulatedRobot::makeSimplemap(const std::string& rawlog, const std::string& name) const
{
    GzInputFile in(rawlog);
    mrpt::maps::CSimpleMap map;
    auto pose = mrpt::poses::CPose3DPDFGaussian::Create();
    auto keyframe = CSensoryFrame::Create();
    const auto complete = [&] {
        if (!keyframe->empty()) map.insert(pose, keyframe);
        keyframe = CSensoryFrame::Create();
    };
    while (const auto object = in.readObject()) {
        const auto observation = std::dynamic_pointer_cast<CObservation>(object);
        if (const auto told = std::dynamic_pointer_cast<CObservationRobotPose>(object)) {
            complete();
            pose = mrpt::poses::CPose3DPDFGaussian::Create();
            pose->mean = told->pose.mean;
        } else if (observation->sensorLabel.rfind("RGBD", 0) == 0) {
            keyframe->insert(observation);
        }
    }
    complete();
    GzOutputFile out(path(name));
    out.writeObject(map);
    out.close();
    return path(name);
}

std::shared_ptr<CVoxelandMap> SimulatedRobot::onlyMapIn(const std::string& folder) const
{
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".voxeland") found.push_back(entry.path().string());
    if (found.size() != 1) {
        ADD_FAILURE() << found.size() << " maps in " << folder;
        return std::make_shared<CVoxelandMap>();
    }
    return loadMap(found.front());
}

std::shared_ptr<CVoxelandMap> SimulatedRobot::mapOf(const std::string& input,
                                                    const std::vector<std::string>& options)
{
    const TemporaryFolder output;
    std::vector<std::string> all{"-i", input, "-o", output.file("map.voxeland"), "--quiet"};
    all.insert(all.end(), options.begin(), options.end());
    const auto result = runProgram("rawlog2voxeland", all);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return onlyMapIn(output.path().string());
}

std::vector<mrpt::math::TPose2D> SimulatedRobot::truth(const std::string& name) const
{
    std::ifstream in(path(name + "_truth") + "/trajectory.tum");
    std::vector<mrpt::math::TPose2D> poses;
    double time = 0, x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 0;
    while (in >> time >> x >> y >> z >> qx >> qy >> qz >> qw)
        poses.emplace_back(x, y, 2 * std::atan2(qz, qw));
    return poses;
}

void expectSameMap(const CVoxelandMap& a, const CVoxelandMap& b)
{
    EXPECT_EQ(a.counts().frames, b.counts().frames);
    EXPECT_EQ(a.counts().framesWithoutPredictions, b.counts().framesWithoutPredictions);
    EXPECT_EQ(a.counts().opinions, b.counts().opinions);
    EXPECT_EQ(a.map().instances().size(), b.map().instances().size());
    EXPECT_TRUE(bytesOf(a.map()) == bytesOf(b.map()));
}
}  // namespace voxeland::test
