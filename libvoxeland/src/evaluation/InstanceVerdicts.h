// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evaluation/EvaluatedScene.h"

#include <optional>
#include <vector>

namespace voxeland
{
/** Whether an instance is right, with what the map thinks of it. */
struct InstanceVerdict
{
    double entropy = 0;      //!< of its category distribution [nat]
    double probability = 0;  //!< of its category
    bool correct = false;
};

/** The object that each instance stands for, by position in the scene: the one it shares most
 * points with, whatever the categories, provided that it has at least `minPoints` points and that
 * their IoU is above 0.25 or more than half of the instance lies on the object. */
std::vector<std::optional<size_t>> objectsOfInstances(const EvaluatedScene& scene,
                                                      size_t minPoints);

/** Are the categories right? Each instance is compared to its object, see objectsOfInstances().
 *  Correct: the same evaluation class. Pairs where neither side has an evaluation class cannot be
 *  judged and are left out. */
std::vector<InstanceVerdict> categoryVerdicts(const std::vector<EvaluatedScene>& scenes,
                                              const EvaluationProtocol& protocol);

/** Are the instances right as a whole? (The paper's precision.) Correct: an object of the same
 *  class with IoU >= 0.5. Instances without an evaluation class, or of fewer than `minPoints`
 *  points, are left out, and so are those that the AP at 0.5 ignores: see matchClass(). */
std::vector<InstanceVerdict> detectionVerdicts(const std::vector<EvaluatedScene>& scenes,
                                               const EvaluationProtocol& protocol);
}  // namespace voxeland
