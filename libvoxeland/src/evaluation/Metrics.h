// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "AveragePrecision.h"
#include "PanopticQuality.h"
#include "Segmentation.h"
#include "voxeland/evaluation/UncertaintyMeasures.h"

#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** Figures of one class, or of all regardless of class. Ratios are in [0,1], NaN without objects.
 */
struct ClassMetrics
{
    std::string name;
    size_t objects = 0, instances = 0;  //!< of at least `minPoints` points
    AveragePrecision precision;
    double pq = 0, sq = 0, rq = 0;  //!< panoptic quality, see PanopticQuality
};

/** How far probabilities are right: expectedCalibrationError() and those beside it. */
struct Confidence
{
    double calibrationError = 0, equalMassError = 0;
    double errorByChance = 0;  //!< calibrationErrorByChance(); NaN for points, which are many
    double brier = 0, logLikelihoodLoss = 0;
    std::vector<ReliabilityBin> diagram;
};

/** How well uncertainty tells right from wrong. */
struct UncertaintyMetrics
{
    size_t judged = 0, wrong = 0;  //!< instances, by categoryVerdicts()
    double auroc = 0;              //!< of their category entropy against a wrong category
    Confidence confidence;         //!< of their category's probability
    std::optional<UncertaintyThreshold> threshold;  //!< suggested for category entropy [nat]
    size_t judgedPoints = 0, wrongPoints = 0;       //!< EvaluatedScene::pointDecisions
    double pointAuroc = 0;       //!< of their instance entropy against a wrong instance
    Confidence pointConfidence;  //!< of their instance's probability
    std::vector<PrecisionAtThreshold> curve;  //!< the paper's, by detectionVerdicts()
};

/** All figures of one scene, or of several taken together. */
struct Metrics
{
    std::vector<ClassMetrics> classes;  //!< those with objects or instances
    ClassMetrics mean;                  //!< over the classes that have objects; counts are sums
    ClassMetrics agnostic;  //!< categories disregarded: all annotated objects, all instances
    SegmentationCounts segmentation;
    UncertaintyMetrics uncertainty;
};

/** Computes everything. \param classNames as LabelMap::classes() */
Metrics evaluate(const std::vector<EvaluatedScene>& scenes,
                 const std::vector<std::string>& classNames, const EvaluationProtocol& protocol);

/** Mean over those entries that have objects; counts are summed. */
ClassMetrics meanOf(const std::vector<ClassMetrics>& entries, const std::string& name);
}  // namespace voxeland
