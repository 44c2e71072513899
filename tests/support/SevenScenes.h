// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace voxeland::test
{
/** Makes one frame of a small dataset laid out as 7-Scenes: a grey colour image, depth of 1 m.
 *  Beside the sequence's folder goes a camera of such small images, unless there is one.
 *  \param stem path up to the number, e.g. "seq-01/frame-000003" \param extension of colour */
void writeSevenScenesFrame(const std::filesystem::path& stem, const std::string& extension = "png",
                           int width = 32, int height = 24);

/** Content of a pose file: the camera at the origin of the world. */
constexpr const char* IDENTITY_POSE = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
}  // namespace voxeland::test
