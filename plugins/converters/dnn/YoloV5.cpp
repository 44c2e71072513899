// SPDX-License-Identifier: BSD-3-Clause
#include "YoloV5.h"

#include <algorithm>

namespace voxeland
{
std::vector<YoloCandidate> candidatesOfYoloV5(const cv::Mat& output, int prototypes,
                                              double minScore)
{
    constexpr int BOX = 4, HEAD = BOX + 1;
    const int places = output.size[1], columns = output.size[2];
    const cv::Mat_<float> table(places, columns,
                                reinterpret_cast<float*>(const_cast<uchar*>(output.data)));

    std::vector<YoloCandidate> candidates;
    for (int p = 0; p < places; ++p) {
        const float* values = table[p];
        const float object = values[BOX];
        const float* classesEnd = values + columns - prototypes;
        const float* top = std::max_element(values + HEAD, classesEnd);
        const float score = object * *top;
        if (!(static_cast<double>(score) >= minScore)) continue;
        YoloCandidate c;
        c.box = {static_cast<double>(values[0] - values[2] / 2),
                 static_cast<double>(values[1] - values[3] / 2), static_cast<double>(values[2]),
                 static_cast<double>(values[3])};
        c.topClass = static_cast<int>(top - values) - HEAD;
        c.score = score;
        std::transform(values + HEAD, classesEnd, std::back_inserter(c.classScores),
                       [object](float s) { return object * s; });
        c.coefficients.assign(classesEnd, values + columns);
        candidates.push_back(std::move(c));
    }
    return candidates;
}
}  // namespace voxeland
