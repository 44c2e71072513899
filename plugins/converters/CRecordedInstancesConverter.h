// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/COpinionConverter.h"

namespace voxeland
{
/** Opinions from the predictions recorded with the rawlog (CObservationInstances): each mask's main
 * cluster with the prediction's distribution and score. */
class CRecordedInstancesConverter : public COpinionConverter
{
    DEFINE_MRPT_OBJECT(CRecordedInstancesConverter, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    [[nodiscard]] std::vector<Opinion> convert(const RgbdFrame& frame,
                                               const VoxelizedFrame& voxels) const override;

 private:
    double m_minScore = 0;
    ClusteringOptions m_clustering;
};
}  // namespace voxeland
