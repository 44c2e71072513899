// SPDX-License-Identifier: BSD-3-Clause
#include "CEvidentialAssociation.h"

#include <mrpt/core/initializer.h>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CEvidentialAssociation, voxeland::CAssociationPolicy, voxeland)

std::string CEvidentialAssociation::description() const
{
    return "the paper's: overlap with the visible part, relaxed by semantic similarity";
}

void CEvidentialAssociation::declareOptions(OptionList& options)
{
    options.add("tau_iou", m_tauIoU, {0, 1}, "Intersection over union that makes a match");
    options.add("tau_iov_strict", m_tauIoVStrict, {0, 1},
                "Intersection over visible that makes a match when categories differ (S_sem = 0)");
    options.add("tau_iov_relaxed", m_tauIoVRelaxed, {0, 1},
                "Intersection over visible that makes a match when categories agree (S_sem = 1)");
}

double CEvidentialAssociation::matchQuality(const Overlap& o) const
{
    const double tauIoV = m_tauIoVStrict + (m_tauIoVRelaxed - m_tauIoVStrict) * o.similarity;
    const bool matches = o.iou() >= m_tauIoU || o.iov() >= tauIoV;
    return matches ? o.iou() + o.iov() : -1;
}

std::vector<Assignment> CEvidentialAssociation::associate(
    const std::vector<OpinionOverlaps>& opinions, const SemanticVoxelMap&) const
{
    std::vector<Assignment> assignments;
    for (const OpinionOverlaps& o : opinions) {
        Assignment best;
        best.newInstance = static_cast<uint32_t>(assignments.size());
        double bestQuality = -1;
        for (const Overlap& candidate : o.candidates) {
            const double quality = matchQuality(candidate);
            if (quality <= bestQuality) continue;
            best.instance = candidate.instance;
            bestQuality = quality;
        }
        assignments.push_back(best);
    }
    return assignments;
}

bool CEvidentialAssociation::mayMerge(const InstanceOverlap& o, const SemanticVoxelMap&) const
{
    return o.iou() > m_mergeIoU || (o.ios() >= m_mergeIoS && o.similarity >= m_mergeSimilarity);
}
}  // namespace voxeland

MRPT_INITIALIZER(registerEvidentialAssociation)
{
    mrpt::rtti::registerClass(CLASS_ID(voxeland::CEvidentialAssociation));
}
