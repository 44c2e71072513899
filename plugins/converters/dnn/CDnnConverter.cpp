// SPDX-License-Identifier: BSD-3-Clause
#include "CDnnConverter.h"

#include "ClassNames.h"
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/nearestWord.h"
#include "voxeland/datasets/CategoryNames.h"
#include "voxeland/observations/ColourImage.h"
#include "voxeland/plugins/ClusteringKeys.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/system/string_utils.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CDnnConverter, voxeland::COpinionConverter, voxeland)

std::string CDnnConverter::description() const
{
    return "a segmentation network (YOLO v5, v8, v11 or Mask R-CNN) looks at the colour images";
}

void CDnnConverter::declareOptions(OptionList& options)
{
    options.add("model", m_files.model, "File of the network: ONNX, or a frozen TensorFlow graph");
    options.add("config", m_files.config, "Description of a frozen graph (.pbtxt); empty: none");
    options.add("labels", m_labels,
                "File of class names; empty: those in the model, COCO's for Mask R-CNN");
    options.add("score_threshold", m_limits.score, {0, 1}, "Least score of a detection");
    options.add("classes", m_classes, "Names of the classes to use, with commas; empty: all",
                OptionList::anyValue);
    options.forExperts();
    options.add("layout", m_layout,
                Words<OutputLayout>{{"auto", OutputLayout::automatic},
                                    {"yolov5", OutputLayout::yolov5},
                                    {"yolov8", OutputLayout::yolov8},
                                    {"mask_rcnn", OutputLayout::maskRcnn}},
                "How the network writes its results; yolov8 is also that of v11");
    options.add("input_width", m_inputWidth, {0, 8192},
                "Width of the network's input; 0: the model says, or 640, or the image's for Mask "
                "R-CNN [pixels]");
    options.add("input_height", m_inputHeight, {0, 8192}, "Its height, likewise [pixels]");
    options.add("nms_threshold", m_limits.overlap, {0, 1},
                "Of boxes of a class with a greater intersection over union, the best is kept");
    options.add("mask_threshold", m_limits.mask, {0.01, 0.99},
                "Least probability of a pixel of a mask");
    options.add("top_classes", m_topClasses, {0, 1e6},
                "Keep so many of the most probable classes of each detection; 0: all");
    options.add("backend", m_device.backend, backendWords(), "What runs the network");
    options.add("target", m_device.target, targetWords(), "Where it runs");
    declareClusteringOptions(options, m_clustering);
}

void CDnnConverter::start()
{
    if (m_files.model.empty())
        throw ConfigurationError("[converter] model is empty: name the file of a network");
    const cv::Size input(static_cast<int>(m_inputWidth), static_cast<int>(m_inputHeight));
    m_network = std::make_unique<SegmentationNetwork>(m_files, m_device, m_layout, input);
    nameClasses();
    readAllowed();
}

void CDnnConverter::nameClasses()
{
    m_classNames = m_labels.empty() ? m_network->classNames() : readClassNames(m_labels);
    if (m_classNames.empty() && m_network->layout() == OutputLayout::maskRcnn)
        for (const auto& [number, name] : cocoCategoryNames()) m_classNames.push_back(name);
    if (m_classNames.empty())
        throw ConfigurationError("the model '" + m_files.model +
                                 "' holds no names of its classes: give a file with [converter] "
                                 "labels");
    const auto classes = static_cast<size_t>(m_network->classes());
    if (classes > 0 && m_classNames.size() != classes)
        throw ConfigurationError("'" + (m_labels.empty() ? m_files.model : m_labels) + "' names " +
                                 counted(m_classNames.size(), "class", "classes") +
                                 " but the network tells " + std::to_string(classes) +
                                 " apart: give its own names with [converter] labels");
}

void CDnnConverter::readAllowed()
{
    std::vector<std::string> names;
    mrpt::system::tokenize(m_classes, ",", names);
    for (const std::string& spaced : names) {
        const std::string name = mrpt::system::trim(spaced);
        if (std::find(m_classNames.begin(), m_classNames.end(), name) == m_classNames.end()) {
            const std::string nearest = nearestWord(name, m_classNames);
            throw ConfigurationError("[converter] classes: the network knows no '" + name + "'" +
                                     (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)"));
        }
        m_allowed.insert(name);
    }
}

CObservationInstances::Ptr CDnnConverter::predict(
    const mrpt::obs::CObservation3DRangeScan& scan) const
{
    const cv::Mat image = colourImage(scan);
    auto predictions = CObservationInstances::Create();
    predictions->imageWidth = image.cols;
    predictions->imageHeight = image.rows;
    for (Detection& d : m_network->detect(image, m_limits)) {
        InstancePrediction p;
        p.categories = categoriesOf(d);
        const bool wanted = m_allowed.empty() ||
                            (!p.categories.empty() && m_allowed.count(p.categories[0].name) > 0);
        if (!wanted) continue;
        p.mask = std::move(d.mask);
        p.score = d.score;
        p.box = {cvFloor(d.box.x), cvFloor(d.box.y), cvCeil(d.box.br().x) - cvFloor(d.box.x),
                 cvCeil(d.box.br().y) - cvFloor(d.box.y)};
        predictions->instances.push_back(std::move(p));
    }
    return predictions;
}

CategoryDistribution CDnnConverter::categoriesOf(const Detection& detection) const
{
    if (detection.classScores.size() > m_classNames.size())
        throw ConfigurationError("the network tells " +
                                 std::to_string(detection.classScores.size()) +
                                 " classes apart but only " + std::to_string(m_classNames.size()) +
                                 " have names: give all with [converter] labels");
    CategoryDistribution scores;
    for (size_t c = 0; c < detection.classScores.size(); ++c)
        scores.push_back({m_classNames[c], detection.classScores[c]});
    scores = normalized(std::move(scores));
    if (m_topClasses > 0 && scores.size() > m_topClasses) scores.resize(m_topClasses);
    return normalized(std::move(scores));
}

std::vector<Opinion> CDnnConverter::convert(const RgbdFrame& frame,
                                            const VoxelizedFrame& voxels) const
{
    return opinionsOf(frame, voxels, m_clustering);
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CDnnConverter> REGISTERED;
