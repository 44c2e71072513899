// SPDX-License-Identifier: BSD-3-Clause
#include "support/Room.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3D.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace voxeland::test
{
std::array<double, 16> Room::cameraToWorld(int step)
{
    // Looks along (cos a, sin a, 0), its y axis down, and moves sideways, forward and up.
    const double a = 0.5 + 0.02 * step;
    const double c = std::cos(a), s = std::sin(a);
    return {s,  0,  c, 1.2 + 0.03 * step,  //
            -c, 0,  s, 1.0 + 0.02 * step,  //
            0,  -1, 0, 1.3 + 0.01 * step,  //
            0,  0,  0, 1};
}

std::array<double, 16> Room::inverse(const std::array<double, 16>& m)
{
    std::array<double, 16> inverse{};
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c) {
            inverse[4 * r + c] = m[4 * c + r];
            inverse[4 * r + 3] -= m[4 * c + r] * m[4 * c + 3];
        }
    inverse[15] = 1;
    return inverse;
}

cv::Mat Room::depth(const std::array<double, 16>& m, const PinholeCamera& camera, int width,
                    int height, double scale)
{
    cv::Mat image(height, width, CV_16U);
    for (int v = 0; v < height; ++v)
        for (int u = 0; u < width; ++u) {
            const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
            double nearest = std::numeric_limits<double>::infinity();
            for (size_t k = 0; k < 3; ++k) {
                const double direction = m[4 * k] * x + m[4 * k + 1] * y + m[4 * k + 2];
                const double wall = direction > 0 ? SIZE[k] : 0;
                if (direction != 0) nearest = std::min(nearest, (wall - m[4 * k + 3]) / direction);
            }
            image.at<uint16_t>(v, u) = static_cast<uint16_t>(std::lround(scale * nearest));
        }
    return image;
}

double Room::distanceToWalls(double x, double y, double z)
{
    double nearest = std::numeric_limits<double>::infinity();
    const std::array<double, 3> p = {x, y, z};
    for (size_t k = 0; k < 3; ++k)
        nearest = std::min({nearest, std::abs(p[k]), std::abs(p[k] - SIZE[k])});
    return nearest;
}

std::string matrixText(const std::array<double, 16>& matrix, int columns)
{
    std::ostringstream text;
    text.precision(12);
    for (size_t i = 0; i < matrix.size(); ++i)
        text << matrix[i] << ((i + 1) % static_cast<size_t>(columns) == 0 ? "\n" : " ");
    return text.str();
}

cv::Mat greyImage(int width, int height)
{
    return cv::Mat(height, width, CV_8UC3, cv::Scalar(90, 90, 90));
}

void writeImage(const std::filesystem::path& file, const cv::Mat& image)
{
    std::filesystem::create_directories(file.parent_path());
    cv::imwrite(file.string(), image);
}

double worstDistanceToWalls(const RgbdRecord& record)
{
    mrpt::maps::CSimplePointsMap points;
    mrpt::obs::T3DPointsProjectionParams params;
    params.takeIntoAccountSensorPoseOnRobot = true;
    const mrpt::poses::CPose3D robot(*record.robotPose);
    params.robotPoseInTheWorld = robot;
    record.scan->unprojectInto(points, params);
    double worst = points.empty() ? std::numeric_limits<double>::infinity() : 0;
    for (size_t i = 0; i < points.size(); ++i) {
        float x = 0, y = 0, z = 0;
        points.getPoint(i, x, y, z);
        worst =
            std::max(worst, Room::distanceToWalls(static_cast<double>(x), static_cast<double>(y),
                                                  static_cast<double>(z)));
    }
    return worst;
}
}  // namespace voxeland::test
