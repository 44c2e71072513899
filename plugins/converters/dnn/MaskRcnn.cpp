// SPDX-License-Identifier: BSD-3-Clause
#include "MaskRcnn.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace voxeland
{
namespace
{
/** One row of the boxes. */
struct Row
{
    float batch, classNumber, score, left, top, right, bottom;
};

/** Spreads the probabilities over the box and cuts them at the threshold. */
RunLengthMask maskOf(const cv::Mat& probabilities, const cv::Rect& box, const cv::Size& image,
                     double threshold)
{
    cv::Mat mask(image, CV_8U, cv::Scalar(0));
    const cv::Rect inside = box & cv::Rect({0, 0}, image);
    if (!inside.empty()) {
        cv::Mat ofBox;
        cv::resize(probabilities, ofBox, box.size(), 0, 0, cv::INTER_LINEAR);
        cv::compare(ofBox(inside - box.tl()), threshold, mask(inside), cv::CMP_GT);
    }
    return RunLengthMask::fromBitmap(mask.data, mask.cols, mask.rows);
}
}  // namespace

std::vector<Detection> detectionsOfMaskRcnn(const cv::Mat& boxes, const cv::Mat& masks,
                                            const cv::Size& image, const DetectionLimits& limits)
{
    const int objects = boxes.size[2], classes = masks.size[1];
    std::vector<Detection> detections;
    for (int i = 0; i < objects; ++i) {
        const Row& row = reinterpret_cast<const Row*>(boxes.ptr<float>(0, 0))[i];
        const auto c = static_cast<int>(row.classNumber);
        if (!(static_cast<double>(row.score) >= limits.score) || c < 0 || c >= classes) continue;
        Detection d;
        d.score = row.score;
        d.classScores.assign(static_cast<size_t>(classes), 0);
        d.classScores[static_cast<size_t>(c)] = row.score;
        const cv::Point2f topLeft(row.left * static_cast<float>(image.width),
                                  row.top * static_cast<float>(image.height));
        const cv::Point2f bottomRight(row.right * static_cast<float>(image.width),
                                      row.bottom * static_cast<float>(image.height));
        const cv::Rect box(cv::Point(cvFloor(topLeft.x), cvFloor(topLeft.y)),
                           cv::Point(cvCeil(bottomRight.x), cvCeil(bottomRight.y)));
        if (box.empty()) continue;
        d.box = cv::Rect2d(topLeft, bottomRight) & cv::Rect2d({0, 0}, cv::Size2d(image));
        const cv::Mat probabilities(masks.size[2], masks.size[3], CV_32F,
                                    const_cast<float*>(masks.ptr<float>(i, c)));
        d.mask = maskOf(probabilities, box, image, limits.mask);
        detections.push_back(std::move(d));
    }
    return detections;
}
}  // namespace voxeland
