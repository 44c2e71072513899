// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evaluation/EvaluatedScene.h"

#include <vector>

namespace voxeland
{
/** Panoptic quality of one class (Kirillov et al., "Panoptic Segmentation", 2019). */
struct PanopticQuality
{
    size_t matched = 0;  //!< object and instance with IoU > 0.5
    size_t unmatchedInstances = 0;
    size_t missedObjects = 0;
    double iouSum = 0;  //!< of the matched

    [[nodiscard]] double segmentation() const;  //!< SQ: mean IoU of the matched; 0 if none
    [[nodiscard]] double recognition() const;   //!< RQ: F1 score of matching; NaN without anything
    [[nodiscard]] double quality() const;       //!< PQ = SQ * RQ
};

/** Counts over all scenes. Where void is ignored it takes no part in the union, and an unmatched
 *  instance with more than half of ignorablePoints() does not count. What has fewer than
 *  `minPoints` points does not count either. */
PanopticQuality panopticQuality(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                                const EvaluationProtocol& protocol);
}  // namespace voxeland
