// SPDX-License-Identifier: BSD-3-Clause
#include "CocoMasks.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace voxeland
{
std::vector<uint32_t> decodeCocoCounts(const std::string& counts)
{
    constexpr int FIRST_CHARACTER = 48, MORE = 32, SIGN = 16, BITS = 5, LONGEST = 60;
    std::vector<uint32_t> runs;
    for (size_t at = 0; at < counts.size();) {
        int64_t value = 0;
        int shift = 0, bits = MORE;
        while ((bits & MORE) != 0) {
            if (at == counts.size() || shift >= LONGEST)
                throw std::invalid_argument("compressed run lengths are cut off");
            bits = counts[at++] - FIRST_CHARACTER;
            if (bits < 0 || bits >= 2 * MORE)
                throw std::invalid_argument("compressed run lengths have a strange character");
            value |= static_cast<int64_t>(static_cast<uint64_t>(bits & (MORE - 1)) << shift);
            shift += BITS;
        }
        if ((bits & SIGN) != 0) value -= static_cast<int64_t>(uint64_t{1} << shift);
        if (runs.size() > 2) value += runs[runs.size() - 2];
        if (value < 0 || value > std::numeric_limits<uint32_t>::max())
            throw std::invalid_argument("compressed run lengths have one that is negative or huge");
        runs.push_back(static_cast<uint32_t>(value));
    }
    return runs;
}

RunLengthMask maskFromColumnRuns(int width, int height, const std::vector<uint32_t>& runs)
{
    // The same runs, read along the rows, are those of the transposed image.
    const std::vector<uint8_t> transposed = RunLengthMask(height, width, runs).toBitmap();
    cv::Mat columns(width, height, CV_8U, const_cast<uint8_t*>(transposed.data()));
    const cv::Mat image = columns.t();
    return RunLengthMask::fromBitmap(image.data, width, height);
}

namespace
{
/** Points x0, y0, x1, y1, ... */
using Polygon = std::vector<double>;

void check(const Polygon& polygon)
{
    if (polygon.size() < 6 || polygon.size() % 2 != 0)
        throw std::invalid_argument("a polygon needs three or more x, y pairs");
    constexpr double FARTHEST = 1e6;
    if (!std::all_of(polygon.begin(), polygon.end(),
                     [](double v) { return std::abs(v) <= FARTHEST; }))
        throw std::invalid_argument("a polygon has a point that is not finite, or far off");
}

/** Where the polygon's edges cross a horizontal line, from left to right. */
std::vector<double> crossings(const Polygon& polygon, double y)
{
    std::vector<double> xs;
    const double* a = &polygon[polygon.size() - 2];
    for (const double* b = polygon.data(); b != polygon.data() + polygon.size(); a = b, b += 2)
        if ((a[1] > y) != (b[1] > y))
            xs.push_back(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
    std::sort(xs.begin(), xs.end());
    return xs;
}
}  // namespace

RunLengthMask maskFromPolygons(int width, int height,
                               const std::vector<std::vector<double>>& polygons)
{
    std::vector<uint8_t> bitmap(static_cast<size_t>(width) * static_cast<size_t>(height), 0);
    // First pixel of a row whose centre is not left of x.
    const auto column = [width](double x) {
        return static_cast<std::ptrdiff_t>(std::ceil(std::clamp(x, 0.0, width + 0.5) - 0.5));
    };
    for (const auto& polygon : polygons) {
        check(polygon);
        for (int row = 0; row < height; ++row) {
            const auto pixels = bitmap.begin() + static_cast<std::ptrdiff_t>(row) * width;
            const auto xs = crossings(polygon, row + 0.5);
            for (size_t i = 0; i + 1 < xs.size(); i += 2)
                std::fill(pixels + column(xs[i]), pixels + column(xs[i + 1]), uint8_t{1});
        }
    }
    return RunLengthMask::fromBitmap(bitmap.data(), width, height);
}
}  // namespace voxeland
