// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evaluation/EvaluatedScene.h"

#include <vector>

namespace voxeland
{
/** How objects, of whatever category, and map instances correspond. Objects of fewer than
 *  `minPoints` points do not count. An instance *takes part* in an object if it has at least a
 *  tenth of the object's points, and *covers* it if it moreover has the most of all instances. */
struct SegmentationCounts
{
    size_t objects = 0;
    size_t instances = 0;       //!< of at least `minPoints` points
    size_t coveredObjects = 0;  //!< objects that an instance covers
    size_t overSegmented = 0;   //!< objects that two instances or more take part in
    size_t underSegmented = 0;  //!< instances that cover two objects or more
};

SegmentationCounts segmentationCounts(const std::vector<EvaluatedScene>& scenes,
                                      const EvaluationProtocol& protocol);
}  // namespace voxeland
