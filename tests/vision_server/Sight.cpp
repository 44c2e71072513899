// SPDX-License-Identifier: BSD-3-Clause
#include "Sight.h"

#include "simulation/CategoryPaint.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace voxeland::test
{
namespace
{
using Votes = std::map<std::string, double>;

/** Pixels within the line that outlines an object: white, between black ones. None if there is no
 * such line. */
cv::Mat insideOutline(const cv::Mat& image)
{
    cv::Mat black, white, line;
    cv::inRange(image, cv::Scalar::all(0), cv::Scalar::all(90), black);
    cv::inRange(image, cv::Scalar::all(180), cv::Scalar::all(255), white);
    cv::dilate(black, black, {}, {-1, -1}, 2);
    cv::dilate(white & black, line, {});
    cv::copyMakeBorder(line, line, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
    cv::floodFill(line, {0, 0}, 255);
    return line(cv::Rect(1, 1, image.cols, image.rows)) == 0;
}

/** Pixels of each paint in a part of a picture, as a share of all painted ones. */
Votes shares(const cv::Mat& image, const cv::Mat& part)
{
    Votes votes;
    double all = 0;
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.cols; ++column) {
            if (part.at<uint8_t>(row, column) == 0) continue;
            const auto pixel = image.at<cv::Vec3b>(row, column);
            const std::string* category = simulation::categoryOfPaint(pixel[2], pixel[1], pixel[0]);
            if (category == nullptr) continue;
            ++votes[*category];
            ++all;
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
        Votes votes = shares(image, insideOutline(image));
        if (votes.empty()) votes = shares(image, cv::Mat(image.size(), CV_8U, cv::Scalar(255)));
        for (const auto& [category, share] : votes) total[category] += share;
    }
    const auto most =
        std::max_element(total.begin(), total.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == total.end() ? std::string() : most->first;
}
}  // namespace voxeland::test
