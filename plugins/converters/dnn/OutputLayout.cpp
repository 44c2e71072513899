// SPDX-License-Identifier: BSD-3-Clause
#include "OutputLayout.h"

#include "MaskRcnn.h"
#include "YoloMasks.h"
#include "YoloV5.h"
#include "YoloV8.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <tuple>

namespace voxeland
{
namespace
{
/** Tensor of the first output with so many dimensions; null if there is none. */
const cv::Mat* tensorOf(const std::vector<NetworkOutput>& outputs, int dimensions)
{
    const auto found = std::find_if(outputs.begin(), outputs.end(),
                                    [&](const auto& o) { return o.tensor.dims == dimensions; });
    return found == outputs.end() ? nullptr : &found->tensor;
}

/** The two outputs of a YOLO network; null if there are no such. */
struct YoloOutputs
{
    const cv::Mat *places, *prototypes;

    explicit YoloOutputs(const std::vector<NetworkOutput>& outputs)
        : places(tensorOf(outputs, 3)), prototypes(tensorOf(outputs, 4))
    {
    }
    [[nodiscard]] bool complete() const { return places != nullptr && prototypes != nullptr; }
};

/** Whether there are so many places on the grids of 8, 16, 32 and perhaps 64 input pixels that go
 * with prototypes of 4 pixels. */
bool arePlaces(int64_t count, const cv::Mat& prototypes, int64_t perCell)
{
    const int64_t cells = static_cast<int64_t>(prototypes.size[2]) * prototypes.size[3];
    const int64_t upTo32 = cells / 4 + cells / 16 + cells / 64;
    return count == perCell * upTo32 || count == perCell * (upTo32 + cells / 256);
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
         {std::tuple(OutputLayout::yolov5, yolo.places->size[1], 3),
          std::tuple(OutputLayout::yolov8, yolo.places->size[2], 1)})
        if (fits(layout, outputs) && arePlaces(places, *yolo.prototypes, perCell)) return layout;
    return OutputLayout::automatic;
}
}  // namespace

OutputLayout recognizeLayout(const std::vector<NetworkOutput>& outputs, OutputLayout named)
{
    const OutputLayout obvious = obviousLayout(outputs);
    const bool isNamed = named != OutputLayout::automatic;
    if (obvious != OutputLayout::automatic && (!isNamed || named == obvious)) return obvious;
    if (obvious == OutputLayout::automatic && isNamed && fits(named, outputs)) return named;
    throw InputError("its outputs are " + shapesText(outputs) + ", which is " +
                     (isNamed ? "not the layout named: leave it to be recognized"
                              : "no layout that is known: give a segmentation model of YOLO v5, v8 "
                                "or v11 or a Mask R-CNN, or name the layout"));
}

int numberOfClasses(OutputLayout layout, const std::vector<NetworkOutput>& outputs)
{
    if (layout == OutputLayout::maskRcnn) return outputs[1].tensor.size[1];
    const YoloOutputs yolo(outputs);
    const int masks = yolo.prototypes->size[1];
    return layout == OutputLayout::yolov5 ? yolo.places->size[2] - 5 - masks
                                          : yolo.places->size[1] - 4 - masks;
}

std::vector<Detection> decode(OutputLayout layout, const std::vector<NetworkOutput>& outputs,
                              const Letterbox& letterbox, const DetectionLimits& limits)
{
    if (layout == OutputLayout::maskRcnn)
        return detectionsOfMaskRcnn(outputs[0].tensor, outputs[1].tensor, letterbox.image(),
                                    limits);
    const YoloOutputs yolo(outputs);
    const int masks = yolo.prototypes->size[1];
    auto candidates = layout == OutputLayout::yolov5
                          ? candidatesOfYoloV5(*yolo.places, masks, limits.score)
                          : candidatesOfYoloV8(*yolo.places, masks, limits.score);
    std::vector<Detection> detections;
    for (const auto& candidate : withoutDuplicates(std::move(candidates), limits.overlap))
        detections.push_back(detectionOf(candidate, *yolo.prototypes, letterbox, limits.mask));
    return detections;
}
}  // namespace voxeland
