// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/GroundTruth.h"
#include "voxeland/evaluation/EvaluatedScene.h"
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland
{
/** Lays a map on its ground truth. Every annotated point takes the instance of the occupied surface
 *  voxel that contains it; where there is none, that of the nearest one whose centre is within
 *  matchRadius(). Where *unknown* wins, or nothing is near, it takes none.
 *
 *  The category of an object is that of the most of its points, the category of an instance its
 *  most probable one.
 *
 *  `pointDecisions` are the points that took an instance, with the entropy of their voxel over
 *  instances [nat] and the probability of the one that wins it; an instance stands for the object
 *  that it shares most points with, and the decision is wrong if the point belongs to another one.
 *  Points of no object are left out, or wrong where void counts as wrong.
 *
 *  \param name of the scene */
EvaluatedScene compare(const SemanticVoxelMap& map, const GroundTruth& truth,
                       const LabelMap& labels, const EvaluationProtocol& protocol,
                       const std::string& name);
}  // namespace voxeland
