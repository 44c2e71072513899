// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluationReport.h"

#include <nlohmann/json.hpp>

using nlohmann::json;

namespace voxeland
{
namespace
{
json toJson(const ClassMetrics& m)
{
    return {{"class", m.name},
            {"objects", m.objects},
            {"instances", m.instances},
            {"ap", m.precision.ap},
            {"ap50", m.precision.ap50},
            {"ap25", m.precision.ap25},
            {"voc_ap50", m.precision.voc50},
            {"pq", m.pq},
            {"sq", m.sq},
            {"rq", m.rq}};
}

json toJson(const SegmentationCounts& s)
{
    return {{"objects", s.objects},
            {"instances", s.instances},
            {"covered_objects", s.coveredObjects},
            {"over_segmented_objects", s.overSegmented},
            {"under_segmented_instances", s.underSegmented}};
}

json toJson(const Confidence& c)
{
    json diagram = json::array();
    for (const ReliabilityBin& b : c.diagram)
        diagram.push_back(
            {{"decisions", b.decisions}, {"probability", b.probability}, {"correct", b.correct}});
    return {{"expected_calibration_error", c.calibrationError},
            {"equal_mass_calibration_error", c.equalMassError},
            {"equal_mass_calibration_error_by_chance", c.errorByChance},
            {"brier_score", c.brier},
            {"negative_log_likelihood", c.logLikelihoodLoss},
            {"reliability", diagram}};
}

json toJson(const UncertaintyMetrics& u)
{
    json curve = json::array();
    for (const PrecisionAtThreshold& p : u.curve)
        curve.push_back({{"threshold", p.threshold},
                         {"precision", p.precision()},
                         {"instances", p.instances},
                         {"correct", p.correct}});
    json result = {{"judged_instances", u.judged},
                   {"wrong_instances", u.wrong},
                   {"category_entropy_auroc", u.auroc},
                   {"expected_calibration_error", u.confidence.calibrationError},
                   {"category_probability", toJson(u.confidence)},
                   {"suggested_entropy_threshold", nullptr},
                   {"judged_points", u.judgedPoints},
                   {"wrong_points", u.wrongPoints},
                   {"instance_entropy_auroc", u.pointAuroc},
                   {"instance_probability", toJson(u.pointConfidence)},
                   {"precision_curve", curve}};
    if (u.threshold)
        result["suggested_entropy_threshold"] = {{"value", u.threshold->value},
                                                 {"youden", u.threshold->youden}};
    return result;
}

json toJson(const Metrics& m)
{
    json classes = json::array();
    for (const ClassMetrics& c : m.classes) classes.push_back(toJson(c));
    return {{"classes", classes},
            {"mean", toJson(m.mean)},
            {"class_agnostic", toJson(m.agnostic)},
            {"segmentation", toJson(m.segmentation)},
            {"uncertainty", toJson(m.uncertainty)}};
}

/** Each side's counterpart: the one with the largest IoU. */
struct Counterparts
{
    explicit Counterparts(const EvaluatedScene& scene)
        : ofObject(scene.objects.size(), nullptr), ofInstance(scene.instances.size(), nullptr)
    {
        for (const SharedPoints& o : scene.overlaps) {
            keepBetter(scene, ofObject[o.object], o);
            keepBetter(scene, ofInstance[o.instance], o);
        }
    }

    static void keepBetter(const EvaluatedScene& scene, const SharedPoints*& best,
                           const SharedPoints& o)
    {
        if (best == nullptr || iou(scene, o) > iou(scene, *best)) best = &o;
    }

    std::vector<const SharedPoints*> ofObject, ofInstance;
};

json className(const LabelMap& labels, class_id_t cls)
{
    if (cls == NO_CLASS) return nullptr;
    return labels.classes()[static_cast<size_t>(cls)];
}

void addSegments(json& to, const EvaluatedScene& scene, const LabelMap& labels)
{
    const Counterparts counterparts(scene);
    to["objects"] = to["instances"] = json::array();
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const TrueObject& o = scene.objects[i];
        json entry = {
            {"id", o.id},         {"category", o.category}, {"class", className(labels, o.cls)},
            {"points", o.points}, {"instance", nullptr},    {"iou", 0}};
        if (const SharedPoints* best = counterparts.ofObject[i]) {
            entry["instance"] = scene.instances[best->instance].id;
            entry["iou"] = iou(scene, *best);
        }
        to["objects"].push_back(entry);
    }
    for (size_t i = 0; i < scene.instances.size(); ++i) {
        const PredictedInstance& p = scene.instances[i];
        json entry = {
            {"id", p.id},           {"category", p.category}, {"class", className(labels, p.cls)},
            {"points", p.points},   {"score", p.score},       {"probability", p.probability},
            {"entropy", p.entropy}, {"object", nullptr},      {"iou", 0}};
        if (const SharedPoints* best = counterparts.ofInstance[i]) {
            entry["object"] = scene.objects[best->object].id;
            entry["iou"] = iou(scene, *best);
        }
        to["instances"].push_back(entry);
    }
}
}  // namespace

std::string EvaluationReport::json() const
{
    nlohmann::json report;
    report["protocol"] = {{"labels", m_labels.source()},
                          {"classes", m_labels.classes()},
                          {"score", toString(m_protocol.score)},
                          {"void", toString(m_protocol.voidPolicy)},
                          {"min_points", m_protocol.minPoints}};
    report["scenes"] = nlohmann::json::array();
    for (size_t i = 0; i < m_scenes.size(); ++i) {
        nlohmann::json scene = toJson(m_metrics[i]);
        scene["name"] = m_scenes[i].name;
        scene["map"] = m_pairs[i].map;
        scene["ground_truth"] = m_pairs[i].truth;
        scene["match_radius"] = m_pairs[i].radius;
        scene["entropy_measure"] = m_pairs[i].entropy;
        addSegments(scene, m_scenes[i], m_labels);
        report["scenes"].push_back(scene);
    }
    report["pooled"] = toJson(pooled());
    report["mean_over_scenes"] = toJson(sceneMean());
    return report.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}
}  // namespace voxeland
