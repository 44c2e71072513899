// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "SegmentationNetwork.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <memory>
#include <set>

namespace voxeland
{
/** Opinions straight from the colour images, by an instance segmentation network that OpenCV's DNN
 * module runs: Ultralytics YOLO v5, v8 and v11 exported to ONNX, or a TensorFlow Mask R-CNN. What
 * it predicts becomes opinions just as recorded predictions do. */
class CDnnConverter : public COpinionConverter
{
    DEFINE_MRPT_OBJECT(CDnnConverter, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    /** Loads the network and tries it on an empty image. */
    void start() override;

    [[nodiscard]] bool makesPredictions() const override { return true; }
    [[nodiscard]] CObservationInstances::Ptr predict(
        const mrpt::obs::CObservation3DRangeScan& scan) const override;
    [[nodiscard]] std::vector<Opinion> convert(const RgbdFrame& frame,
                                               const VoxelizedFrame& voxels) const override;

 private:
    void nameClasses();
    void readAllowed();
    [[nodiscard]] CategoryDistribution categoriesOf(const Detection& detection) const;

    NetworkFiles m_files;
    NetworkDevice m_device;
    std::string m_labels, m_classes;
    OutputLayout m_layout = OutputLayout::automatic;
    uint32_t m_inputWidth = 0, m_inputHeight = 0, m_topClasses = 0;
    DetectionLimits m_limits;
    ClusteringOptions m_clustering;

    std::unique_ptr<SegmentationNetwork> m_network;
    std::vector<std::string> m_classNames;  //!< by class number
    std::set<std::string> m_allowed;        //!< empty: all
};
}  // namespace voxeland
