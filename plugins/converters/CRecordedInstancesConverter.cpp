// SPDX-License-Identifier: BSD-3-Clause
#include "CRecordedInstancesConverter.h"

#include "voxeland/base/RegisteredClass.h"
#include "voxeland/plugins/ClusteringKeys.h"

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
    return opinionsOf(frame, voxels, m_clustering, m_minScore);
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CRecordedInstancesConverter> REGISTERED;
