// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluationReport.h"

#include "voxeland/base/counted.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/printable.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace voxeland
{
namespace
{
constexpr int NAME_WIDTH = 22, NUMBER_WIDTH = 7;

/** A ratio in percent, or a dash. */
std::string percent(double ratio)
{
    return std::isnan(ratio) ? "-" : fixedText(100 * ratio, 1);
}

std::string decimal(double value)
{
    return std::isnan(value) ? "-" : fixedText(value, 3);
}

void writeRow(std::ostream& out, const std::string& name, const std::vector<std::string>& cells)
{
    out << "  " << std::left << std::setw(NAME_WIDTH) << printable(name) << std::right;
    for (const std::string& c : cells) out << std::setw(NUMBER_WIDTH) << c;
    out << "\n";
}

void writeHeader(std::ostream& out)
{
    writeRow(out, "class", {"truth", "map", "AP", "AP50", "AP25", "VOC50", "PQ", "SQ", "RQ"});
}

void writeClass(std::ostream& out, const ClassMetrics& m)
{
    writeRow(out, m.name,
             {std::to_string(m.objects), std::to_string(m.instances), percent(m.precision.ap),
              percent(m.precision.ap50), percent(m.precision.ap25), percent(m.precision.voc50),
              percent(m.pq), percent(m.sq), percent(m.rq)});
}

void writeUncertainty(std::ostream& out, const UncertaintyMetrics& u)
{
    out << "  category entropy:   AUROC " << decimal(u.auroc) << " against a wrong category ("
        << u.wrong << " of " << counted(u.judged, "matched instance") << " wrong)\n"
        << "  category probability: calibration error " << decimal(u.confidence.calibrationError)
        << " (10 bins), " << decimal(u.confidence.equalMassError) << " (of equal mass; "
        << decimal(u.confidence.errorByChance) << " by chance), Brier score "
        << decimal(u.confidence.brier) << ", negative log-likelihood "
        << decimal(u.confidence.logLikelihoodLoss) << " nat\n"
        << "  suggested threshold: ";
    if (u.threshold)
        out << decimal(u.threshold->value) << " nat (Youden's J " << decimal(u.threshold->youden)
            << ")\n";
    else
        out << "none, entropy does not tell right from wrong here\n";
    out << "  instance entropy:   AUROC " << decimal(u.pointAuroc) << " against a wrong instance ("
        << u.wrongPoints << " of " << counted(u.judgedPoints, "point") << " wrong)\n"
        << "  instance probability: calibration error "
        << decimal(u.pointConfidence.calibrationError) << " (10 bins), Brier score "
        << decimal(u.pointConfidence.brier) << "\n";
}

void writeMetrics(std::ostream& out, const Metrics& m)
{
    writeHeader(out);
    for (const ClassMetrics& c : m.classes) writeClass(out, c);
    writeClass(out, m.mean);
    writeClass(out, m.agnostic);
    const SegmentationCounts& s = m.segmentation;
    out << "  segmentation: " << s.coveredObjects << " of " << counted(s.objects, "object")
        << " covered, " << s.overSegmented << " over-segmented; " << s.underSegmented << " of "
        << counted(s.instances, "instance") << " under-segmented\n";
    writeUncertainty(out, m.uncertainty);
}

void writeProtocol(std::ostream& out, const LabelMap& labels, const EvaluationProtocol& protocol)
{
    const bool ignore = protocol.voidPolicy == VoidPolicy::ignore;
    constexpr size_t MOST_NAMED = 20;
    const size_t classes = labels.classes().size();
    out << "Protocol\n  classes: " << classes << " of " << printable(labels.source(), UNCUT);
    for (size_t i = 0; i < classes && classes <= MOST_NAMED; ++i)
        out << (i == 0 ? ": " : ", ") << printable(labels.classes()[i]);
    out << "\n"
        << "  a ground-truth point takes the instance of its voxel, else of the nearest occupied "
           "voxel in reach\n"
        << "  score: " << toString(protocol.score) << "; at least "
        << counted(protocol.minPoints, "point") << " an instance; void "
        << (ignore ? "is ignored" : "counts as false positive") << "\n"
        << "  AP: ScanNet, mean over IoU > 0.50, 0.55, ... 0.90; AP50, AP25: ScanNet at one "
           "threshold; VOC50: all-point area, IoU > 0.50\n"
        << "  PQ, SQ, RQ: panoptic quality, IoU > 0.50; mean: over the classes with objects; "
           "class-agnostic: all objects; all figures in percent\n";
}
}  // namespace

EvaluationReport::EvaluationReport(LabelMap labels, const EvaluationProtocol& protocol)
    : m_labels(std::move(labels)), m_protocol(protocol)
{
}

void EvaluationReport::add(const Pair& pair, EvaluatedScene scene)
{
    m_pairs.push_back(pair);
    m_scenes.push_back(std::move(scene));
    m_metrics.push_back(evaluate({m_scenes.back()}, m_labels.classes(), m_protocol));
}

Metrics EvaluationReport::pooled() const
{
    return m_scenes.size() == 1 ? m_metrics.front()
                                : evaluate(m_scenes, m_labels.classes(), m_protocol);
}

ClassMetrics EvaluationReport::sceneMean() const
{
    std::vector<ClassMetrics> means;
    for (const Metrics& m : m_metrics) means.push_back(m.mean);
    return meanOf(means, "mean of scene means");
}

std::string EvaluationReport::text() const
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    writeProtocol(out, m_labels, m_protocol);
    for (size_t i = 0; i < m_scenes.size(); ++i) {
        const Pair& p = m_pairs[i];
        out << "\nScene " << printable(m_scenes[i].name) << "\n  map " << printable(p.map, UNCUT)
            << ", ground truth " << printable(p.truth, UNCUT) << ", reach " << decimal(p.radius)
            << " m, entropy '" << p.entropy << "'\n";
        writeMetrics(out, m_metrics[i]);
    }
    if (m_scenes.size() < 2) return out.str();
    out << "\nAll " << m_scenes.size() << " scenes pooled (ScanNet)\n";
    writeMetrics(out, pooled());
    out << "\nMean over scenes (paper)\n";
    writeHeader(out);
    for (size_t i = 0; i < m_scenes.size(); ++i) {
        ClassMetrics mean = m_metrics[i].mean;
        mean.name = m_scenes[i].name;
        writeClass(out, mean);
    }
    writeClass(out, sceneMean());
    return out.str();
}

std::string reliabilityCsv(const UncertaintyMetrics& uncertainty)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "of,decisions,probability,correct\n";
    for (const auto& [of, confidence] :
         {std::pair<const char*, const Confidence*>{"instances", &uncertainty.confidence},
          {"points", &uncertainty.pointConfidence}})
        for (const ReliabilityBin& b : confidence->diagram)
            out << of << "," << b.decisions << "," << b.probability << "," << b.correct << "\n";
    return out.str();
}

std::string precisionCurveCsv(const std::vector<PrecisionAtThreshold>& curve)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "threshold_nat,precision,instances,correct\n";
    for (const PrecisionAtThreshold& p : curve) {
        out << p.threshold << ",";
        if (p.instances > 0) out << p.precision();
        out << "," << p.instances << "," << p.correct << "\n";
    }
    return out.str();
}
}  // namespace voxeland
