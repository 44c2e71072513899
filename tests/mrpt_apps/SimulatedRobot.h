// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <gtest/gtest.h>
#include <mrpt/math/TPose2D.h>

#include <memory>
#include <string>
#include <vector>

namespace voxeland::test
{
/** How a program of MRPT gets to know Voxeland's classes. */
enum class Way
{
    Preload,  //!< the stock program, with the library in LD_PRELOAD
    Launcher  //!< voxeland-run
};

/** Name of a way, for messages. */
std::string nameOf(Way way);

/** Runs a program of MRPT in a folder. */
ProgramResult runMrpt(Way way, const std::string& folder, const std::string& program,
                      const std::vector<std::string>& arguments);

/** Path of the library under test. */
std::string voxelandLibrary();

/** Whether a program can be found in the PATH. */
bool isInstalled(const std::string& program);

/** An INI of share/config/mrpt. */
std::string mrptConfig(const std::string& name);

/** A robot drives through a simulated room; its rawlogs lie in a folder of their own. */
class SimulatedRobot : public testing::Test
{
 protected:
    /** Simulates more of the same drive.
     *  \param options beyond those of size and place
     *  \return path of the rawlog */
    std::string simulate(const std::string& name, int frames,
                         const std::vector<std::string>& options);
    /** The same observations as a simplemap: keyframes of true pose, each with the scan and its
     *  predictions. \return its path */
    std::string makeSimplemap(const std::string& rawlog, const std::string& name) const;
    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] std::string folder() const { return m_folder.path().string(); }

    /** The only map in a folder whose name ends so. */
    [[nodiscard]] std::shared_ptr<CVoxelandMap> onlyMapIn(const std::string& folder) const;
    /** What rawlog2voxeland makes of a rawlog or simplemap. */
    [[nodiscard]] std::shared_ptr<CVoxelandMap> mapOf(const std::string& input,
                                                      const std::vector<std::string>& options = {});
    /** True poses of the robot, of the simulation of that name. */
    [[nodiscard]] std::vector<mrpt::math::TPose2D> truth(const std::string& name) const;

 private:
    TemporaryFolder m_folder;
};

/** Two maps must hold the same. */
void expectSameMap(const CVoxelandMap& a, const CVoxelandMap& b);
}  // namespace voxeland::test

/** Ends a test as SKIPPED where a program of MRPT is not installed. */
#define SKIP_WITHOUT(program) \
    if (!voxeland::test::isInstalled(program)) GTEST_SKIP() << program << " is not installed"
