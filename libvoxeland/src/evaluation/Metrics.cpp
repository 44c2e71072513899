// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics.h"

#include "InstanceVerdicts.h"

#include <limits>

namespace voxeland
{
namespace
{
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

template <typename Segments>
size_t countOf(const Segments& segments, class_id_t cls, size_t minPoints)
{
    size_t n = 0;
    for (const auto& s : segments)
        if (s.cls == cls && s.points > 0 && s.points >= minPoints) ++n;
    return n;
}

ClassMetrics evaluateClass(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                           const std::string& name, const EvaluationProtocol& protocol)
{
    ClassMetrics m;
    m.name = name;
    for (const EvaluatedScene& s : scenes) {
        m.objects += countOf(s.objects, cls, protocol.minPoints);
        m.instances += countOf(s.instances, cls, protocol.minPoints);
    }
    m.precision = averagePrecision(scenes, cls, protocol);
    const PanopticQuality panoptic = panopticQuality(scenes, cls, protocol);
    m.pq = m.objects == 0 ? NOT_A_NUMBER : panoptic.quality();
    m.sq = m.objects == 0 ? NOT_A_NUMBER : panoptic.segmentation();
    m.rq = m.objects == 0 ? NOT_A_NUMBER : panoptic.recognition();
    return m;
}

/** All but what chance would give. */
Confidence confidenceIn(const std::vector<ConfidentDecision>& decisions)
{
    Confidence c;
    c.diagram = reliability(decisions);
    c.calibrationError = expectedCalibrationError(decisions);
    c.equalMassError = calibrationErrorOf(c.diagram);
    c.errorByChance = NOT_A_NUMBER;
    c.brier = brierScore(decisions);
    c.logLikelihoodLoss = negativeLogLikelihood(decisions);
    return c;
}

UncertaintyMetrics evaluateUncertainty(const std::vector<EvaluatedScene>& scenes,
                                       const EvaluationProtocol& protocol)
{
    UncertaintyMetrics m;
    std::vector<UncertainDecision> categories, detections, points;
    std::vector<ConfidentDecision> confidences, pointConfidences;
    for (const InstanceVerdict& v : categoryVerdicts(scenes, protocol)) {
        ++m.judged;
        if (!v.correct) ++m.wrong;
        categories.push_back({v.entropy, !v.correct});
        confidences.push_back({v.probability, v.correct});
    }
    for (const InstanceVerdict& v : detectionVerdicts(scenes, protocol))
        detections.push_back({v.entropy, !v.correct});
    for (const EvaluatedScene& s : scenes)
        points.insert(points.end(), s.pointDecisions.begin(), s.pointDecisions.end());
    for (const UncertainDecision& p : points) {
        ++m.judgedPoints;
        if (p.wrong) ++m.wrongPoints;
        pointConfidences.push_back({p.probability, !p.wrong});
    }
    m.auroc = areaUnderRoc(categories);
    m.confidence = confidenceIn(confidences);
    m.confidence.errorByChance = calibrationErrorByChance(confidences);
    m.pointConfidence = confidenceIn(pointConfidences);
    m.threshold = suggestedThreshold(categories);
    m.pointAuroc = areaUnderRoc(std::move(points));
    m.curve = precisionCurve(detections);
    return m;
}
}  // namespace

ClassMetrics meanOf(const std::vector<ClassMetrics>& entries, const std::string& name)
{
    ClassMetrics sum;
    sum.name = name;
    double n = 0;
    for (const ClassMetrics& e : entries) {
        sum.objects += e.objects;
        sum.instances += e.instances;
        if (e.objects > 0) ++n;
    }
    const auto average = [&](auto figure) {
        double total = 0;
        for (const ClassMetrics& e : entries)
            if (e.objects > 0) total += figure(e);
        return n > 0 ? total / n : NOT_A_NUMBER;
    };
    sum.precision.ap = average([](const ClassMetrics& e) { return e.precision.ap; });
    sum.precision.ap50 = average([](const ClassMetrics& e) { return e.precision.ap50; });
    sum.precision.ap25 = average([](const ClassMetrics& e) { return e.precision.ap25; });
    sum.precision.voc50 = average([](const ClassMetrics& e) { return e.precision.voc50; });
    sum.pq = average([](const ClassMetrics& e) { return e.pq; });
    sum.sq = average([](const ClassMetrics& e) { return e.sq; });
    sum.rq = average([](const ClassMetrics& e) { return e.rq; });
    return sum;
}

Metrics evaluate(const std::vector<EvaluatedScene>& scenes,
                 const std::vector<std::string>& classNames, const EvaluationProtocol& protocol)
{
    Metrics m;
    for (size_t i = 0; i < classNames.size(); ++i) {
        ClassMetrics c = evaluateClass(scenes, static_cast<class_id_t>(i), classNames[i], protocol);
        if (c.objects + c.instances > 0) m.classes.push_back(std::move(c));
    }
    m.mean = meanOf(m.classes, "mean");
    std::vector<EvaluatedScene> agnostic;
    for (const EvaluatedScene& s : scenes) agnostic.push_back(classAgnostic(s));
    m.agnostic = evaluateClass(agnostic, 0, "class-agnostic", protocol);
    m.segmentation = segmentationCounts(scenes, protocol);
    m.uncertainty = evaluateUncertainty(scenes, protocol);
    return m;
}
}  // namespace voxeland
