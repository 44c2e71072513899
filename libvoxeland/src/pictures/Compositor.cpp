// SPDX-License-Identifier: BSD-3-Clause
#include "Compositor.h"

#include <opencv2/imgproc.hpp>

namespace voxeland
{
namespace
{
constexpr float VEIL = 0.45F;  //!< opacity of *unknown* in front of an object

/** Number of pixels that show an object with nothing in front of it. */
int visibleObjectPixels(const Sight& sight)
{
    return cv::countNonZero(sight.objects.depth() < sight.background.depth());
}

cv::Vec3f lit(const VoxelRaster& raster, int row, int column, const std::vector<Color>& colors)
{
    const Color& c = colors[static_cast<size_t>(raster.voxel()(row, column))];
    return cv::Vec3f(c.blue, c.green, c.red) * raster.light()(row, column);
}
}  // namespace

double bestAzimuth(const VoxelScene& scene, cv::Size image)
{
    const cv::Size small(image.width / 8, image.height / 8);
    double best = 0;
    int most = -1;
    for (int eighth = 1; eighth < 16; eighth += 2) {
        const double azimuth = eighth * CV_PI / 8;
        const auto camera = ViewCamera::perspective(scene, small, azimuth);
        const int pixels = visibleObjectPixels(Sight(scene, camera, small));
        if (pixels <= most) continue;
        most = pixels;
        best = azimuth;
    }
    return best;
}

cv::Mat3b composite(const Sight& sight, const std::vector<Color>& colors)
{
    cv::Mat3b picture(sight.objects.voxel().size(), cv::Vec3b(255, 255, 255));
    for (int row = 0; row < picture.rows; ++row)
        for (int column = 0; column < picture.cols; ++column) {
            const bool object = sight.objects.voxel()(row, column) != VoxelRaster::NOTHING;
            const bool other = sight.background.voxel()(row, column) != VoxelRaster::NOTHING;
            if (!object && !other) continue;
            const cv::Vec3f front = object ? lit(sight.objects, row, column, colors) : cv::Vec3f();
            if (!other) {
                picture(row, column) = front;
                continue;
            }
            const cv::Vec3f back = lit(sight.background, row, column, colors);
            const bool veiled =
                sight.background.depth()(row, column) < sight.objects.depth()(row, column);
            if (!object)
                picture(row, column) = back;
            else
                picture(row, column) = veiled ? front * (1 - VEIL) + back * VEIL : front;
        }
    cv::Mat3b fine;
    cv::resize(picture, fine, picture.size() / OVERSAMPLING, 0, 0, cv::INTER_AREA);
    return fine;
}
}  // namespace voxeland
