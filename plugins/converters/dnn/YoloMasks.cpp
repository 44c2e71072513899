// SPDX-License-Identifier: BSD-3-Clause
#include "YoloMasks.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
double intersectionOverUnion(const cv::Rect2d& a, const cv::Rect2d& b)
{
    const double common = (a & b).area();
    const double all = a.area() + b.area() - common;
    return all > 0 ? common / all : 0;
}

/** The pixels whose centres are in the box. */
cv::Rect pixelsOf(const cv::Rect2d& box)
{
    const auto first = [](double v) { return static_cast<int>(std::ceil(v - 0.5)); };
    return {cv::Point(first(box.x), first(box.y)), cv::Point(first(box.br().x), first(box.br().y))};
}
}  // namespace

std::vector<YoloCandidate> withoutDuplicates(std::vector<YoloCandidate> candidates,
                                             double maxOverlap)
{
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](const YoloCandidate& a, const YoloCandidate& b) { return a.score > b.score; });
    std::vector<YoloCandidate> kept;
    for (YoloCandidate& c : candidates) {
        const bool isDuplicate = std::any_of(kept.begin(), kept.end(), [&](const auto& k) {
            return k.topClass == c.topClass && intersectionOverUnion(k.box, c.box) > maxOverlap;
        });
        if (!isDuplicate) kept.push_back(std::move(c));
    }
    return kept;
}

Detection detectionOf(const YoloCandidate& candidate, const cv::Mat& prototypes,
                      const Letterbox& letterbox, double maskThreshold)
{
    const int n = prototypes.size[1], height = prototypes.size[2], width = prototypes.size[3];
    const cv::Mat weights(1, n, CV_32F, const_cast<float*>(candidate.coefficients.data()));
    const cv::Mat layers(n, height * width, CV_32F, const_cast<uchar*>(prototypes.data));
    const cv::Mat small = cv::Mat(weights * layers).reshape(1, height);
    cv::Mat ofInput, ofImage;
    cv::resize(small, ofInput, letterbox.input(), 0, 0, cv::INTER_LINEAR);
    cv::resize(ofInput(letterbox.content()), ofImage, letterbox.image(), 0, 0, cv::INTER_LINEAR);

    Detection detection;
    detection.box = letterbox.toImage(candidate.box);
    const double threshold = std::log(maskThreshold / (1 - maskThreshold));
    const cv::Rect inside = pixelsOf(detection.box) & cv::Rect({0, 0}, letterbox.image());
    cv::Mat mask(letterbox.image(), CV_8U, cv::Scalar(0));
    if (!inside.empty()) cv::compare(ofImage(inside), threshold, mask(inside), cv::CMP_GT);
    detection.mask = RunLengthMask::fromBitmap(mask.data, mask.cols, mask.rows);
    detection.classScores = candidate.classScores;
    detection.score = candidate.score;
    return detection;
}
}  // namespace voxeland
