// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/CocoMasks.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

RunLengthMask maskFromPolygons(int width, int height,
                               const std::vector<std::vector<double>>& polygons)
{
    constexpr int SHIFT = 4;  // fillPoly takes points in 1/16 pixel
    constexpr double FARTHEST = 1e6;
    const auto fixed = [](double v) {  // OpenCV's pixel (0, 0) has its centre at (0, 0)
        if (!(std::abs(v) < FARTHEST)) throw std::invalid_argument("a polygon point is far off");
        return static_cast<int>(std::lround((v - 0.5) * (1 << SHIFT)));
    };
    cv::Mat image(height, width, CV_8U, cv::Scalar(0));
    for (const auto& p : polygons) {
        if (p.size() < 6 || p.size() % 2 != 0)
            throw std::invalid_argument("a polygon needs three or more x, y pairs");
        std::vector<cv::Point> points;
        for (size_t i = 0; i < p.size(); i += 2) points.emplace_back(fixed(p[i]), fixed(p[i + 1]));
        cv::fillPoly(image, std::vector<std::vector<cv::Point>>{points}, cv::Scalar(1), cv::LINE_8,
                     SHIFT);
    }
    return RunLengthMask::fromBitmap(image.data, width, height);
}
}  // namespace voxeland
