// SPDX-License-Identifier: BSD-3-Clause
#include "CameraCheck.h"

#include "Projection.h"
#include "base/sizeText.h"
#include "voxeland/base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

using mrpt::img::DistortionModel;
using mrpt::img::TCamera;

namespace voxeland
{
namespace
{
double radians(double degrees)
{
    return degrees * M_PI / 180;
}

/** Whether a focal length suits an image that long [pixels]. */
bool isPossible(double focal, double pixels, bool isFisheye)
{
    const double most = pixels / 2 / std::tan(radians(CameraLimits::NARROWEST) / 2);
    const double least = isFisheye ? pixels / radians(360)
                                   : pixels / 2 / std::tan(radians(CameraLimits::WIDEST) / 2);
    return focal >= least && focal <= most;
}

/** Whether a direction is found that the distortion brings to a pixel. */
bool isUndistortable(const TCamera& camera, double column, double row)
{
    constexpr int ITERATIONS = 100;
    const double tolerance = 0.02 * std::max(camera.ncols, camera.nrows);  // [pixels]
    const double u = (column - camera.cx()) / camera.fx(), v = (row - camera.cy()) / camera.fy();
    double x = u, y = v;
    for (int i = 0; i < ITERATIONS; ++i) {
        const auto at = projected(camera, x, y);
        const double du = at[0] - column, dv = at[1] - row;
        if (std::hypot(du, dv) < tolerance) return true;
        // Half of each step: fixed points of strong distortions are approached without swinging.
        x -= du / camera.fx() / 2;
        y -= dv / camera.fy() / 2;
    }
    return false;
}
}  // namespace

std::string problemOf(const TCamera& camera)
{
    const double fx = camera.fx(), fy = camera.fy(), cx = camera.cx(), cy = camera.cy();
    const double columns = camera.ncols, rows = camera.nrows;
    const auto isFinite = [](double v) { return std::isfinite(v); };
    if (!std::all_of(camera.dist.begin(), camera.dist.end(), isFinite))
        return "has a distortion that is no number";
    const bool isFisheye = camera.distortion == DistortionModel::kannala_brandt;
    if (!isPossible(fx, columns, isFisheye) || !isPossible(fy, rows, isFisheye))
        return "has focal lengths of " + numberText(fx) + " and " + numberText(fy) +
               " pixels, which no camera with images of " + sizeText(camera.ncols, camera.nrows) +
               " pixels has";
    if (!(cx > 0 && cx < columns && cy > 0 && cy < rows))
        return "has a principal point at (" + fixedText(cx, 1) + ", " + fixedText(cy, 1) +
               "), outside of its image of " + sizeText(camera.ncols, camera.nrows) +
               " pixels, as if it were of another size";
    if (isFisheye ||
        std::all_of(camera.dist.begin(), camera.dist.end(), [](double d) { return d == 0; }))
        return "";
    for (const auto& [column, row] : {std::array{0.0, cy}, std::array{columns - 1, cy},
                                      std::array{cx, 0.0}, std::array{cx, rows - 1}})
        if (!isUndistortable(camera, column, row))
            return "has a distortion that cannot be undone at the sides of its image";
    return "";
}
}  // namespace voxeland
