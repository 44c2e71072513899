// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evaluation/EvaluatedScene.h"

#include <optional>
#include <vector>

namespace voxeland
{
/** Area under the ROC curve of telling wrong decisions by their uncertainty: the probability that
 *  a wrong one is more uncertain than a right one, equal uncertainties counting one half (exact,
 *  by ranks). NaN unless there are both. */
double areaUnderRoc(std::vector<UncertainDecision> decisions);

/** Where to draw the line between certain and uncertain. */
struct UncertaintyThreshold
{
    double value = 0;   //!< decisions above it are the uncertain ones
    double youden = 0;  //!< share of the wrong ones above it minus share of the right ones, (0,1]
};

/** The threshold with the largest Youden index, half way between the two uncertainties it
 *  separates; of equally good ones the highest, which doubts least. Nothing if there are not both
 *  right and wrong decisions, or if uncertainty does not tell them apart. */
std::optional<UncertaintyThreshold> suggestedThreshold(std::vector<UncertainDecision> decisions);

/** One decision with the probability it was given. */
struct ConfidentDecision
{
    double probability = 0;  //!< [0,1]
    bool correct = false;
};

/** Expected calibration error: mean over the decisions of |accuracy - mean probability| of their
 *  bin; bins of equal width, closed above. NaN without decisions. */
double expectedCalibrationError(const std::vector<ConfidentDecision>& decisions, int bins = 10);

/** Some decisions of like probability, in a reliability diagram. */
struct ReliabilityBin
{
    size_t decisions = 0;    //!< > 0
    double probability = 0;  //!< mean of what they were given
    double correct = 0;      //!< share of them that are
};

/** The diagram: bins of equally many decisions (but for one), in order of their probability. */
std::vector<ReliabilityBin> reliability(std::vector<ConfidentDecision> decisions, int bins = 10);

/** Expected calibration error with the bins of a diagram. NaN if it is empty. */
double calibrationErrorOf(const std::vector<ReliabilityBin>& diagram);
/** The same with those of reliability(). */
double equalMassCalibrationError(std::vector<ConfidentDecision> decisions, int bins = 10);

/** What equalMassCalibrationError() would be on average if every probability was right: few
 * decisions differ from what is expected of them by chance. Mean of 200 draws, the same each time.
 * NaN without decisions. */
double calibrationErrorByChance(std::vector<ConfidentDecision> decisions, int bins = 10);

/** Mean over the decisions of (probability - 1 if correct, else 0)^2 (Brier 1950). NaN without
 * decisions. */
double brierScore(const std::vector<ConfidentDecision>& decisions);

/** Mean over the decisions of -ln of the probability given to what happened [nat]; probabilities
 * nearer to 0 or 1 than 1e-6 count as that. NaN without decisions. */
double negativeLogLikelihood(const std::vector<ConfidentDecision>& decisions);

/** A point of the paper's curve of precision against entropy. */
struct PrecisionAtThreshold
{
    double threshold = 0;  //!< only instances with an entropy below it count [nat]
    size_t instances = 0;
    size_t correct = 0;

    /** NaN where no instance counts. */
    [[nodiscard]] double precision() const;
};

/** The curve at multiples of `step`, from `step` to the first above all uncertainties. */
std::vector<PrecisionAtThreshold> precisionCurve(const std::vector<UncertainDecision>& decisions,
                                                 double step = 0.05);
}  // namespace voxeland
