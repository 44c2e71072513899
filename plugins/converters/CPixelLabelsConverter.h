// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/COpinionConverter.h"

namespace voxeland
{
/** Opinions from the labels of a scan's pixels (mrpt::obs::TPixelLabelInfo): each connected region
 * of a label that has a name is taken for an object. Labels say nothing about how sure they are, so
 * that the score comes from the INI. Pixels are those of the colour image, or of the depth image
 * where the scan has no other. */
class CPixelLabelsConverter : public COpinionConverter
{
    DEFINE_MRPT_OBJECT(CPixelLabelsConverter, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;

    [[nodiscard]] bool makesPredictions() const override { return true; }
    /** Regions by increasing number of the label, from the top of the image to the bottom; null for
     * a scan without labels. */
    [[nodiscard]] CObservationInstances::Ptr predict(
        const mrpt::obs::CObservation3DRangeScan& scan) const override;
    [[nodiscard]] std::vector<Opinion> convert(const RgbdFrame& frame,
                                               const VoxelizedFrame& voxels) const override;

 private:
    double m_score = 0.8;
    uint32_t m_minPixels = 50;
    ClusteringOptions m_clustering;
};
}  // namespace voxeland
