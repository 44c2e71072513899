// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Network.h"
#include "OutputLayout.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <memory>
#include <optional>
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
    [[nodiscard]] Letterbox letterboxFor(const cv::Size& image) const;
    /** What the network makes of an image of 8 bits, blue, green and red. */
    [[nodiscard]] std::vector<NetworkOutput> run(const cv::Mat& image,
                                                 const Letterbox& letterbox) const;
    /** How many classes the network has, where that shows before it sees an image. */
    [[nodiscard]] std::optional<int> tryNetwork();
    void checkInputSize() const;
    void nameClasses(std::optional<int> classes);
    void readAllowed();
    [[nodiscard]] CategoryDistribution categoriesOf(const Detection& detection) const;

    std::string m_model, m_config, m_labels, m_classes;
    OutputLayout m_layout = OutputLayout::automatic;
    uint32_t m_inputWidth = 0, m_inputHeight = 0, m_topClasses = 0;
    DetectionLimits m_limits;
    Network::Device m_device;
    ClusteringOptions m_clustering;

    std::unique_ptr<Network> m_network;
    std::vector<std::string> m_classNames;  //!< by class number
    std::set<std::string> m_allowed;        //!< empty: all
};
}  // namespace voxeland
