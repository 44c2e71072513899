// SPDX-License-Identifier: BSD-3-Clause
#include "YoloV8.h"

#include <algorithm>

namespace voxeland
{
std::vector<YoloCandidate> candidatesOfYoloV8(const cv::Mat& output, int prototypes,
                                              double minScore)
{
    constexpr int BOX = 4;
    const int rows = output.size[1], places = output.size[2], classes = rows - BOX - prototypes;
    const cv::Mat table(rows, places, CV_32F, const_cast<uchar*>(output.data));
    cv::Mat best;
    cv::reduce(table.rowRange(BOX, BOX + classes), best, 0, cv::REDUCE_MAX);

    std::vector<YoloCandidate> candidates;
    for (int p = 0; p < places; ++p) {
        if (!(static_cast<double>(best.at<float>(p)) >= minScore)) continue;
        const cv::Mat_<float> column = table.col(p).clone();
        const float* values = column[0];
        YoloCandidate c;
        c.box = {static_cast<double>(values[0] - values[2] / 2),
                 static_cast<double>(values[1] - values[3] / 2), static_cast<double>(values[2]),
                 static_cast<double>(values[3])};
        c.classScores.assign(values + BOX, values + BOX + classes);
        const auto top = std::max_element(c.classScores.begin(), c.classScores.end());
        c.topClass = static_cast<int>(top - c.classScores.begin());
        c.score = *top;
        c.coefficients.assign(values + BOX + classes, values + rows);
        candidates.push_back(std::move(c));
    }
    return candidates;
}
}  // namespace voxeland
