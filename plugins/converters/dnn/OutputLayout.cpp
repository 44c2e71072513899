// SPDX-License-Identifier: BSD-3-Clause
#include "OutputLayout.h"

#include "MaskRcnn.h"
#include "YoloMasks.h"
#include "YoloV5.h"
#include "YoloV8.h"
#include "voxeland/base/errors.h"

#include <algorithm>
#include <tuple>

namespace voxeland
{
namespace
{
/** Tensor of the first output with so many dimensions; empty if there is none. */
cv::Mat tensorOf(const std::vector<NetworkOutput>& outputs, int dimensions)
{
    const auto found = std::find_if(outputs.begin(), outputs.end(),
                                    [&](const auto& o) { return o.tensor.dims == dimensions; });
    return found == outputs.end() ? cv::Mat() : found->tensor;
}

/** Whether there are so many places on the grids of 8, 16, 32 and perhaps 64 input pixels that go
 * with prototypes of 4 pixels. */
bool arePlaces(int64_t count, const cv::Mat& prototypes, int64_t perCell)
{
    const int64_t cells = static_cast<int64_t>(prototypes.size[2]) * prototypes.size[3];
    const int64_t upTo32 = cells / 4 + cells / 16 + cells / 64;
    return count == perCell * upTo32 || count == perCell * (upTo32 + cells / 256);
}

/** The two outputs of a YOLO network; empty if there are no such. */
struct YoloOutputs
{
    cv::Mat places, prototypes;

    explicit YoloOutputs(const std::vector<NetworkOutput>& outputs)
        : places(tensorOf(outputs, 3)), prototypes(tensorOf(outputs, 4))
    {
    }
    [[nodiscard]] bool complete() const { return !places.empty() && !prototypes.empty(); }
    /** Whether this is v8's turned: a row for each place. */
    [[nodiscard]] bool isTurnedV8() const
    {
        constexpr int BOX = 4;
        return complete() && arePlaces(places.size[1], prototypes, 1) &&
               !arePlaces(places.size[2], prototypes, 1) &&
               places.size[2] > BOX + prototypes.size[1];
    }
    /** As v8 has it: a column for each place. */
    [[nodiscard]] cv::Mat columns() const
    {
        cv::Mat turned = places;
        if (isTurnedV8()) cv::transposeND(places, {0, 2, 1}, turned);
        return turned;
    }
};

/** What helps if outputs have no layout that is known. */
std::string remedyFor(const std::vector<NetworkOutput>& outputs)
{
    const YoloOutputs yolo(outputs);
    constexpr int BOX_SCORE_AND_CLASS = 6;
    if (!yolo.complete() && !yolo.places.empty())
        return "which are those of a detector without masks: export a model made for the task "
               "segment, such as yolov8n-seg.pt";
    if (yolo.complete() && yolo.places.size[2] == BOX_SCORE_AND_CLASS + yolo.prototypes.size[1])
        return "which are those of a network that sorts overlaps out itself: export it anew with "
               "nms=False "
               "end2end=False";
    return "which is no layout that is known: give a segmentation model of YOLO v5, v8 or v11 or a "
           "Mask "
           "R-CNN, or name the layout";
}

/** Whether outputs of these shapes can be read in this layout. */
bool fits(OutputLayout layout, const std::vector<NetworkOutput>& outputs)
{
    if (layout == OutputLayout::maskRcnn) {
        constexpr int COLUMNS = 7;
        return outputs.size() == 2 && outputs[0].tensor.dims == 4 && outputs[1].tensor.dims == 4 &&
               outputs[0].tensor.size[3] == COLUMNS &&
               outputs[1].tensor.size[0] >= outputs[0].tensor.size[2];
    }
    return YoloOutputs(outputs).complete() && numberOfClasses(layout, outputs) > 0;
}

/** The layout that the shapes leave no doubt of; automatic if there is none. */
OutputLayout obviousLayout(const std::vector<NetworkOutput>& outputs)
{
    if (fits(OutputLayout::maskRcnn, outputs)) return OutputLayout::maskRcnn;
    const YoloOutputs yolo(outputs);
    if (!yolo.complete()) return OutputLayout::automatic;
    for (const auto& [layout, places, perCell] :
         {std::tuple(OutputLayout::yolov5, yolo.places.size[1], 3),
          std::tuple(OutputLayout::yolov8, yolo.places.size[2], 1)})
        if (fits(layout, outputs) && arePlaces(places, yolo.prototypes, perCell)) return layout;
    return OutputLayout::automatic;
}
}  // namespace

OutputLayout recognizeLayout(const std::vector<NetworkOutput>& outputs, OutputLayout named)
{
    const OutputLayout obvious = obviousLayout(outputs);
    const bool isNamed = named != OutputLayout::automatic;
    if (obvious != OutputLayout::automatic && (!isNamed || named == obvious)) return obvious;
    if (obvious == OutputLayout::automatic && isNamed && fits(named, outputs)) return named;
    if (!isNamed && YoloOutputs(outputs).isTurnedV8()) return OutputLayout::yolov8;
    throw InputError("its outputs are " + shapesText(outputs) + ", " +
                     (isNamed ? "which is not the layout named: leave it to be recognized"
                              : remedyFor(outputs)));
}

int numberOfClasses(OutputLayout layout, const std::vector<NetworkOutput>& outputs)
{
    if (layout == OutputLayout::maskRcnn) return outputs[1].tensor.size[1];
    const YoloOutputs yolo(outputs);
    const int masks = yolo.prototypes.size[1];
    return layout == OutputLayout::yolov5 ? yolo.places.size[2] - 5 - masks
                                          : yolo.columns().size[1] - 4 - masks;
}

std::vector<Detection> decode(OutputLayout layout, const std::vector<NetworkOutput>& outputs,
                              const Letterbox& letterbox, const DetectionLimits& limits)
{
    if (layout == OutputLayout::maskRcnn)
        return detectionsOfMaskRcnn(outputs[0].tensor, outputs[1].tensor, letterbox.image(),
                                    limits);
    const YoloOutputs yolo(outputs);
    const int masks = yolo.prototypes.size[1];
    auto candidates = layout == OutputLayout::yolov5
                          ? candidatesOfYoloV5(yolo.places, masks, limits.score)
                          : candidatesOfYoloV8(yolo.columns(), masks, limits.score);
    std::vector<Detection> detections;
    for (const auto& candidate : withoutDuplicates(std::move(candidates), limits.overlap))
        detections.push_back(detectionOf(candidate, yolo.prototypes, letterbox, limits.mask));
    return detections;
}
}  // namespace voxeland
