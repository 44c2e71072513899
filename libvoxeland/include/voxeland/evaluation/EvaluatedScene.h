// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/LabelMap.h"
#include "voxeland/evaluation/EvaluationProtocol.h"
#include "voxeland/map/VoxelEvidence.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxeland
{
/** An annotated object. Sizes here and below are numbers of ground-truth points. */
struct TrueObject
{
    uint32_t id = 0;            //!< as in the ground truth
    std::string category;       //!< its name in the ground truth
    class_id_t cls = NO_CLASS;  //!< its evaluation class
    size_t points = 0;
};

/** An instance of the map, as it lies on the ground truth. */
struct PredictedInstance
{
    instance_id_t id = UNKNOWN_INSTANCE;
    std::string category;       //!< the most probable one
    class_id_t cls = NO_CLASS;  //!< its evaluation class
    size_t points = 0;          //!< all that it takes, annotated or not
    double score = 0;           //!< rank in precision-recall curves, by ScoreKind
    double probability = 0;     //!< of the category
    double entropy = 0;         //!< of its distribution over categories [nat]
};

/** Points that an object and an instance have in common: their overlap. */
struct SharedPoints
{
    size_t object = 0, instance = 0;  //!< positions in EvaluatedScene
    size_t points = 0;                //!< > 0
};

/** One decision that comes with an uncertainty, and whether it was wrong. */
struct UncertainDecision
{
    double uncertainty = 0;
    bool wrong = false;
    double probability = 0;  //!< that was given to what was decided, in [0,1]
};

/** A map beside its ground truth, in counts: all that the metrics need. */
struct EvaluatedScene
{
    std::string name;
    std::vector<TrueObject> objects;
    std::vector<PredictedInstance> instances;
    std::vector<SharedPoints> overlaps;  //!< ordered by object, then instance
    std::vector<UncertainDecision>
        pointDecisions;  //!< of points about their instance, see compare()
};

/** Intersection over union of the two sides of an overlap, in (0,1]. */
double iou(const EvaluatedScene& scene, const SharedPoints& overlap);

/** Points of each instance that no object of an evaluated class has: void. */
std::vector<size_t> voidPoints(const EvaluatedScene& scene);

/** Points of each instance that speak neither for nor against it: those on objects of its class
 *  that are smaller than the protocol's minimum, and void unless that counts as wrong. */
std::vector<size_t> ignorablePoints(const EvaluatedScene& scene,
                                    const EvaluationProtocol& protocol);

/** The same scene with one class, 0, for all objects and instances, whatever their category. */
EvaluatedScene classAgnostic(EvaluatedScene scene);
}  // namespace voxeland
