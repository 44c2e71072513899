// SPDX-License-Identifier: BSD-3-Clause
#include "ScanNetAnnotation.h"

#include "AnnotatedObjects.h"
#include "ImageFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** The folder of an annotation, filtered if there is that. */
fs::path folderOf(const fs::path& scene, const std::string& name)
{
    for (const fs::path& folder : {scene / (name + "-filt"), scene / name})
        if (fs::is_directory(folder)) return folder;
    throw InputError("there is no folder " + (scene / (name + "-filt")).string() +
                     ": unpack ScanNet's _2d-" + name + "-filt.zip there");
}

/** Numbers of an image's pixels. */
std::vector<uint32_t> readLabels(const fs::path& file,
                                 const mrpt::obs::CObservation3DRangeScan& scan)
{
    if (!fs::exists(file)) throw UnusableFrame("no annotation");
    cv::Mat image = readImage(file.string(), "annotation");
    if (image.channels() != 1 || (image.depth() != CV_8U && image.depth() != CV_16U))
        throw InputError(file.string() + " is not an image of 8 or 16 bits and one channel");
    if (image.cols != static_cast<int>(scan.intensityImage.getWidth()) ||
        image.rows != static_cast<int>(scan.intensityImage.getHeight()))
        throw InputError(file.string() + " is not of the size of the frame's colour image");
    image.convertTo(image, CV_32S);
    return {image.begin<int32_t>(), image.end<int32_t>()};
}
}  // namespace

ScanNetAnnotation::ScanNetAnnotation(const fs::path& sceneFolder)
    : m_instances(folderOf(sceneFolder, "instance")),
      m_labels(folderOf(sceneFolder, "label")),
      m_categories(sceneFolder)
{
}

CObservationInstances::Ptr ScanNetAnnotation::instancesOf(
    int64_t frame, const mrpt::obs::CObservation3DRangeScan& scan) const
{
    const std::string name = std::to_string(frame) + ".png";
    const auto objects = readLabels(m_instances / name, scan);
    const auto labels = readLabels(m_labels / name, scan);
    std::map<uint32_t, std::map<uint32_t, size_t>> pixels;  // object -> label -> number
    for (size_t i = 0; i < objects.size(); ++i) ++pixels[objects[i]][labels[i]];
    const auto categoryOf = [&](uint32_t object) {
        const auto& counts = pixels.at(object);
        const auto most =
            std::max_element(counts.begin(), counts.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        return m_categories.ofNumber(most->first);
    };
    return predictionsOf(objects, static_cast<int>(scan.intensityImage.getWidth()),
                         static_cast<int>(scan.intensityImage.getHeight()), categoryOf);
}
}  // namespace voxeland
