// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/DatasetCameras.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose3D.h>

#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <regex>
#include <vector>

namespace voxeland
{
/** All numbers of a text file, "nan" and "inf" included; what is no number ends it. */
std::vector<double> readNumbers(const std::filesystem::path& file);

/** Reads a number, "nan" and "inf" included. \return false if there is none */
bool readNumber(std::istream& in, double& number);

/** Robot pose from a camera-to-world matrix, row-major, of optical axes.
 *  \throws UnusableFrame, saying why, if it is none */
std::shared_ptr<mrpt::math::TPose3D> poseFromNumbers(const std::vector<double>& matrix);

/** Camera from a file with its 3x3 or 4x4 matrix. \throws InputError if it holds none */
PinholeCamera readCameraMatrix(const std::filesystem::path& file);

/** What a folder holds, by name; hidden files, such as the `._` twins that macOS makes of any file,
 *  left out. */
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

/** Files of a folder by the number in their name.
 *  \param pattern of the whole name, with the number as its first group */
std::map<int64_t, std::filesystem::path> numberedFiles(const std::filesystem::path& folder,
                                                       const std::regex& pattern);

/** Time of a frame in a dataset without timestamps, at 30 Hz.
 *  \param start of the dataset [s since 1970] \param number of the frame, from 0 */
mrpt::Clock::time_point timeOfFrame(double start, int64_t number);

/** \throws InputError, naming it, if there is no such folder */
void checkFolder(const std::string& folder);
}  // namespace voxeland
