// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** The parts of an image's path, the file's name first, without its ending; everything that is
 *  neither letter nor digit is the same. Both kinds of slashes separate. */
std::vector<std::string> imagePath(const std::string& path);

/** An image's name as it was before Roboflow ("a_jpg.rf.0123abc.jpg" was "a.jpg"). */
std::string beforeRoboflow(const std::string& path);
/** An image's name as it was before Label Studio ("0123abcd-a.jpg" was "a.jpg"). */
std::string beforeLabelStudio(const std::string& path);

/** The last number in the name of an image's file. */
std::optional<int64_t> numberIn(const std::string& path);
/** The number that the name is, "000012.jpg". */
std::optional<int64_t> numberThatIs(const std::string& path);
}  // namespace voxeland
