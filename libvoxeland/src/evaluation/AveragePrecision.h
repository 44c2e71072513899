// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evaluation/EvaluatedScene.h"

#include <vector>

namespace voxeland
{
/** Instances of one class that were right or wrong at one overlap threshold. */
struct RankedMatches
{
    /** An instance that counts. */
    struct Entry
    {
        double score = 0;
        bool correct = false;
    };
    std::vector<Entry> entries;
    size_t objects = 0;  //!< objects to be found
    size_t missed = 0;   //!< objects that no instance matched
};

/** Matches the instances of a class to its objects, over all scenes, as ScanNet's benchmark does:
 *  - objects and instances of fewer than `minPoints` points do not count;
 *  - an object is found by the first instance of its class, in the scene's order and not yet used,
 *    whose IoU is above the threshold (not equal); each further one is wrong, with the lower of the
 *    two scores, and the object keeps the higher;
 *  - an instance with no object of its class above the threshold is wrong, unless the share of its
 *    ignorablePoints() is above the threshold too. */
RankedMatches matchClass(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                         double iouThreshold, const EvaluationProtocol& protocol);

/** A point of the curve of precision over recall. */
struct PrecisionRecall
{
    double precision = 0, recall = 0;  //!< [0,1]
};

/** Precision and recall of what scores at least s, for each score s that occurs, in increasing
 *  order of s, so that recall falls. */
std::vector<PrecisionRecall> precisionRecall(const RankedMatches& matches);

/** Area under the curve by ScanNet's rule: the point (1, recall 0) is added, and each precision
 *  weighs half the distance in recall between its neighbours. NaN without objects. */
double scannetArea(const RankedMatches& matches);

/** Area under the curve by the rule of VOC 2010 and later: the precision at a recall is the best
 *  at this recall or a higher one. NaN without objects. */
double vocArea(const RankedMatches& matches);

/** Average precisions of one class; NaN without objects. */
struct AveragePrecision
{
    double ap = 0;     //!< ScanNet: mean over the thresholds 0.50, 0.55, ... 0.90
    double ap50 = 0;   //!< ScanNet, threshold 0.50
    double ap25 = 0;   //!< ScanNet, threshold 0.25
    double voc50 = 0;  //!< VOC's area, threshold 0.50
};

AveragePrecision averagePrecision(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                                  const EvaluationProtocol& protocol);
}  // namespace voxeland
