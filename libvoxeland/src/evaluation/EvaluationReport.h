// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Metrics.h"

#include <string>
#include <vector>

namespace voxeland
{
/** Everything one evaluation found, with what it depends on. */
class EvaluationReport
{
 public:
    /** One map with its ground truth. */
    struct Pair
    {
        std::string map, truth;  //!< file names
        double radius = 0;       //!< matchRadius() of this map [m]
        std::string entropy;     //!< the map's entropy measure
    };

    EvaluationReport(LabelMap labels, const EvaluationProtocol& protocol);

    /** Evaluates a scene by itself and keeps it for the pooled figures. */
    void add(const Pair& pair, EvaluatedScene scene);

    /** All scenes taken as one, as ScanNet's benchmark does. */
    [[nodiscard]] Metrics pooled() const;

    /** The protocol and tables of figures, to be read. */
    [[nodiscard]] std::string text() const;
    /** The same, and each object's and instance's counterpart, as JSON; a figure that does not
     *  exist is null. */
    [[nodiscard]] std::string json() const;

 private:
    /** Mean over the scenes of their means over classes, as in the paper. */
    [[nodiscard]] ClassMetrics sceneMean() const;

    LabelMap m_labels;
    EvaluationProtocol m_protocol;
    std::vector<Pair> m_pairs;
    std::vector<EvaluatedScene> m_scenes;
    std::vector<Metrics> m_metrics;  //!< of each scene
};

/** The reliability diagrams of instances and of points as CSV: of,decisions,probability,correct. */
std::string reliabilityCsv(const UncertaintyMetrics& uncertainty);

/** They as a PNG picture: the share that is right against the probability, which are equal on the
 * diagonal. \return the file's bytes */
std::string reliabilityPng(const UncertaintyMetrics& uncertainty);

/** The curve as CSV: threshold_nat,precision,instances,correct. */
std::string precisionCurveCsv(const std::vector<PrecisionAtThreshold>& curve);

/** The curve as a PNG picture: precision, and the number of instances that count, against the
 *  entropy threshold. \return the file's bytes
 *  \param threshold marked with a line, if there is one */
std::string precisionCurvePng(const std::vector<PrecisionAtThreshold>& curve,
                              const std::optional<UncertaintyThreshold>& threshold);
}  // namespace voxeland
