// SPDX-License-Identifier: BSD-3-Clause
#include "CIoUAssociation.h"

#include "voxeland/base/RegisteredClass.h"

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CIoUAssociation, voxeland::CAssociationPolicy, voxeland)

namespace
{
bool haveSameTopCategory(const CategoryEvidence& a, const CategoryEvidence& b)
{
    return !a.empty() && a.top() == b.top();
}
}  // namespace

std::string CIoUAssociation::description() const
{
    return "intersection over union and most probable category only, as earlier systems do";
}

void CIoUAssociation::declareOptions(OptionList& options)
{
    options.add("tau_iou", m_tauIoU, {0, 1}, "Least intersection over union of a match");
    options.add("same_category", m_sameCategory,
                "Only match instances of the same most probable category");
}

std::vector<Assignment> CIoUAssociation::associate(const std::vector<OpinionOverlaps>& opinions,
                                                   const SemanticVoxelMap& map) const
{
    std::vector<Assignment> assignments;
    for (const OpinionOverlaps& o : opinions) {
        Assignment best;
        best.newInstance = static_cast<uint32_t>(assignments.size());
        double bestIoU = m_tauIoU;
        for (const Overlap& candidate : o.candidates) {
            if (candidate.intersection == 0) continue;
            const CategoryEvidence known = map.instance(candidate.instance).evidence();
            if (m_sameCategory && !haveSameTopCategory(known, o.categories)) continue;
            const bool better = best.instance == UNKNOWN_INSTANCE ? candidate.iou() >= bestIoU
                                                                  : candidate.iou() > bestIoU;
            if (!better) continue;
            best.instance = candidate.instance;
            bestIoU = candidate.iou();
        }
        assignments.push_back(best);
    }
    return assignments;
}

bool CIoUAssociation::mayMerge(const InstanceOverlap& overlap, const MergeThresholds& thresholds,
                               const SemanticVoxelMap& map) const
{
    if (!(overlap.iou() > thresholds.iou)) return false;
    return !m_sameCategory || haveSameTopCategory(map.instance(overlap.a).evidence(),
                                                  map.instance(overlap.b).evidence());
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CIoUAssociation> REGISTERED;
