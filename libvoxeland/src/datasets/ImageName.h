// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** The parts of an image's path, the file's name first, without its ending; everything that is
 *  neither letter nor digit is the same, and so are small and capital letters. Both kinds of
 *  slashes separate. */
std::vector<std::string> imagePath(const std::string& path);

/** An image's name as it was before Roboflow ("a_jpg.rf.0123abc.jpg" was "a.jpg"). */
std::string beforeRoboflow(const std::string& path);
/** An image's name as it was before Label Studio ("0123abcd-a.jpg" was "a.jpg"). */
std::string beforeLabelStudio(const std::string& path);

/** Whether a text is the name of an image's file without folder and ending, and no number. */
bool isStem(const std::string& text);

/** Whether a name that differs from another only in its numbers has a smaller one first, or where
 *  both names are decimal numbers, is the smaller one: it should not follow the other. */
bool comesBefore(const std::string& path, const std::string& other);

/** The last number in the name of an image's file. */
std::optional<int64_t> numberIn(const std::string& path);
/** The number that the name is, "000012.jpg". */
std::optional<int64_t> numberThatIs(const std::string& path);
}  // namespace voxeland
