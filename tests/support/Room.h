// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <filesystem>
#include <string>

namespace voxeland::test
{
/** An empty room, 4 m by 5 m and 3 m high, with a corner of it as the world's origin: what a depth
 *  camera measures in it is known exactly. */
struct Room
{
    static constexpr std::array<double, 3> SIZE = {4, 5, 3};  //!< [m]

    /** Pose of a camera on its way through the room: a row-major camera-to-world matrix of optical
     *  axes. \param step from 0; neighbouring ones are some centimetres and degrees apart */
    static std::array<double, 16> cameraToWorld(int step);
    /** The inverse of such a matrix. */
    static std::array<double, 16> inverse(const std::array<double, 16>& matrix);
    /** Depth image of 16 bits, as a camera without distortion sees the room.
     *  \param scale numbers that make a metre */
    static cv::Mat depth(const std::array<double, 16>& cameraToWorld, const PinholeCamera& camera,
                         int width, int height, double scale);
    /** Distance of a point to the nearest wall [m]. */
    static double distanceToWalls(double x, double y, double z);
};

/** A matrix as text, \p columns numbers a line. */
std::string matrixText(const std::array<double, 16>& matrix, int columns = 4);

/** A grey colour image. */
cv::Mat greyImage(int width, int height);

/** Writes an image file, making its folder. */
void writeImage(const std::filesystem::path& file, const cv::Mat& image);

/** Largest distance between the room's walls and what MRPT makes of a record's depth image,
 *  calibration and pose [m]. */
double worstDistanceToWalls(const RgbdRecord& record);
}  // namespace voxeland::test
