// SPDX-License-Identifier: BSD-3-Clause
#include "Sight.h"

#include "voxeland/simulation/CategoryPaint.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace voxeland::test
{
namespace
{
using Votes = std::map<std::string, double>;

/** Share of each paint in a picture; pixels count more the nearer to its middle they are. */
Votes shares(const cv::Mat& image)
{
    Votes votes;
    double all = 0;
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.cols; ++column) {
            const double x = 2.0 * column / image.cols - 1, y = 2.0 * row / image.rows - 1;
            const double weight = std::max(0.0, 1 - x * x - y * y);
            const auto pixel = image.at<cv::Vec3b>(row, column);
            const std::string* category = simulation::categoryOfPaint(pixel[2], pixel[1], pixel[0]);
            if (category == nullptr) continue;
            votes[*category] += weight;
            all += weight;
        }
    for (auto& [category, share] : votes) share /= all;
    return votes;
}
}  // namespace

std::string categoryShown(const std::vector<std::string>& pictures)
{
    Votes total;
    for (const std::string& file : pictures) {
        const cv::Mat image =
            cv::imdecode(std::vector<uchar>(file.begin(), file.end()), cv::IMREAD_COLOR);
        if (image.empty()) throw std::runtime_error("a picture cannot be decoded");
        for (const auto& [category, share] : shares(image)) total[category] += share;
    }
    const auto most =
        std::max_element(total.begin(), total.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == total.end() ? std::string() : most->first;
}
}  // namespace voxeland::test
