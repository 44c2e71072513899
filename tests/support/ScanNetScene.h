// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "support/Room.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace voxeland::test
{
/** The room as ScanNet publishes scenes, made without the readers: colour of 120x90 pixels, depth
 *  of 80x60, each with a camera of its own. */
struct ScanNetScene
{
    static constexpr int COLOUR_WIDTH = 120, COLOUR_HEIGHT = 90, DEPTH_WIDTH = 80,
                         DEPTH_HEIGHT = 60;
    static constexpr double COLOUR_FOCAL = 90, DEPTH_FOCAL = 60;

    /** One frame of a `.sens` file, as it stands there. */
    struct SensFrame
    {
        std::array<double, 16> cameraToWorld{};
        uint64_t time = 0;  //!< of both images [us]
        std::string colour, depth;
    };

    /** Depth image of the room at a step [mm]. */
    static cv::Mat depth(int step);
    /** A frame with JPEG colour and zlib depth. */
    static SensFrame sensFrame(int step);
    /** The bytes of a version 4 file. */
    static std::string sensFile(const std::vector<SensFrame>& frames, int32_t colourCompression = 2,
                                int32_t depthCompression = 1, float depthShift = 1000);

    /** Writes extracted frames, at steps 0, 1, ... */
    static void writeFolder(const std::filesystem::path& folder, int frames);
    /** Writes annotated images of a frame: object 1 (objectId 0) in the left half, a "kitchen
     *  table", object 2 in the rightmost column, a wall; and the table of labels. */
    static void writeAnnotation(const std::filesystem::path& folder, int frame);
    /** Writes a few lines of the table of labels. */
    static void writeTable(const std::filesystem::path& folder);
};
}  // namespace voxeland::test
