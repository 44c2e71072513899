// SPDX-License-Identifier: BSD-3-Clause
/** MRPT's SceneViewer3D shows our maps. */
#include "SimulatedRobot.h"

#include <chrono>
#include <future>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** Number of pixels of a vivid colour in what Xvfb keeps in a file: an XWD image, 32 bits a pixel.
 *  The program's own controls are grey. */
size_t vividPixels(const std::string& framebuffer)
{
    if (!std::filesystem::exists(framebuffer)) return 0;
    const std::string bytes = readFile(framebuffer);
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(bytes[i]); };
    size_t vivid = 0;
    constexpr size_t HEADER = 4096;  // more than the header has
    for (size_t i = HEADER; i + 3 < bytes.size(); i += 4) {
        const auto [low, high] = std::minmax({byte(i), byte(i + 1), byte(i + 2)});
        vivid += high - low > 100 ? 1 : 0;
    }
    return vivid;
}

using MrptViewing = SimulatedRobot;
}  // namespace

TEST_F(MrptViewing, SceneViewer3DShowsAMapsObjects)
{
    SKIP_WITHOUT("SceneViewer3D");
    SKIP_WITHOUT("xvfb-run");
    const auto rawlog = simulate("robot", 10, {"--embed", "--images", "embedded"});
    ASSERT_EQ(runProgram("rawlog2voxeland", {"-i", rawlog, "-o", path("map.voxeland"), "--quiet"})
                  .exitCode,
              0);
    ASSERT_EQ(
        runProgram("voxeland-export", {"-m", path("map.voxeland"), "--scene", path("map.3Dscene")})
            .exitCode,
        0);
    // The viewer ends when told to, or shows by its exit code that it ended by itself.
    writeFile(path("view.sh"),
              "SceneViewer3D -l \"$1\" map.3Dscene & viewer=$!\n"
              "until [ -e stop ] || ! kill -0 $viewer; do sleep 0.2; done\n"
              "kill $viewer\n");
    auto viewing = std::async(std::launch::async, [&] {
        return runProgramIn(
            folder(), "timeout",
            {"300", "xvfb-run", "-a", "-s", "-screen 0 800x600x24 -fbdir " + folder(), "bash",
             "view.sh", voxelandLibrary()});
    });
    // However long it takes: ctest ends the test then, and timeout what it has started.
    size_t vivid = 0;
    while (vivid < 1000 &&
           viewing.wait_for(std::chrono::milliseconds(200)) == std::future_status::timeout)
        vivid = vividPixels(path("Xvfb_screen0"));
    writeFile(path("stop"), "");
    const auto result = viewing.get();
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_GE(vivid, 1000U) << result.errors;
}
