// SPDX-License-Identifier: BSD-3-Clause
#include "CRecordedInstancesConverter.h"

#include "voxeland/plugins/ClusteringKeys.h"

#include <mrpt/core/initializer.h>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CRecordedInstancesConverter, voxeland::COpinionConverter, voxeland)

std::string CRecordedInstancesConverter::description() const
{
    return "predictions recorded in the rawlog or its sidecar";
}

void CRecordedInstancesConverter::declareOptions(OptionList& options)
{
    options.add("min_score", m_minScore, {0, 1}, "Predictions with a lower score are left out");
    declareClusteringOptions(options, m_clustering);
}

std::vector<Opinion> CRecordedInstancesConverter::convert(const RgbdFrame& frame,
                                                          const VoxelizedFrame& voxels) const
{
    std::vector<Opinion> opinions;
    if (!frame.instances) return opinions;
    for (const InstancePrediction& p : frame.instances->instances) {
        const bool usable = p.score > 0 && static_cast<double>(p.score) >= m_minScore;
        if (!usable || p.categories.empty()) continue;
        auto points = mainCluster(voxels, p.mask, m_clustering);
        if (!points.empty())
            opinions.push_back(
                {std::move(points), p.categories, p.score, p.track, regionOf(p.mask)});
    }
    return opinions;
}
}  // namespace voxeland

MRPT_INITIALIZER(registerRecordedInstancesConverter)
{
    mrpt::rtti::registerClass(CLASS_ID(voxeland::CRecordedInstancesConverter));
}
