// SPDX-License-Identifier: BSD-3-Clause
#include "CPixelLabelsConverter.h"

#include "voxeland/base/RegisteredClass.h"
#include "voxeland/base/errors.h"
#include "voxeland/plugins/ClusteringKeys.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CPixelLabelsConverter, voxeland::COpinionConverter, voxeland)

namespace
{
using mrpt::obs::TPixelLabelInfo;
using mrpt::obs::TPixelLabelInfoBase;

/** Sets of labels by pixel: bit n stands for label n. */
struct LabelImage
{
    static constexpr uint32_t MOST_LABELS = 64;

    int rows = 0, columns = 0;
    std::vector<uint64_t> sets;  //!< row by row

    /** Takes over the labels if they are stored in so many bytes. */
    template <unsigned int BYTES>
    bool read(const TPixelLabelInfoBase& info)
    {
        const auto* labels = dynamic_cast<const TPixelLabelInfo<BYTES>*>(&info);
        if (labels == nullptr) return false;
        const auto& matrix = labels->pixelLabels;
        rows = static_cast<int>(matrix.rows());
        columns = static_cast<int>(matrix.cols());
        sets.assign(matrix.data(), matrix.data() + matrix.size());
        return true;
    }

    explicit LabelImage(const TPixelLabelInfoBase& info)
    {
        const bool known =
            read<1>(info) || read<2>(info) || read<3>(info) || read<4>(info) || read<8>(info);
        if (!known)
            throw InputError("pixel labels of " + std::to_string(info.BITFIELD_BYTES) +
                             " bytes cannot be used");
    }

    /** Where a label is set. */
    [[nodiscard]] cv::Mat pixelsOf(uint32_t label) const
    {
        cv::Mat pixels(rows, columns, CV_8U);
        std::transform(sets.begin(), sets.end(), pixels.begin<uint8_t>(),
                       [label](uint64_t set) { return static_cast<uint8_t>(set >> label & 1); });
        return pixels;
    }
};

/** The connected parts of an image's set pixels that have at least so many of them. */
std::vector<RunLengthMask> regionsOf(const cv::Mat& pixels, uint32_t minPixels)
{
    constexpr int NEIGHBOURS = 8;
    cv::Mat numbers, statistics, centroids;
    const int count =
        cv::connectedComponentsWithStats(pixels, numbers, statistics, centroids, NEIGHBOURS);
    std::vector<RunLengthMask> regions;
    for (int i = 1; i < count; ++i) {  // 0 is what is not set
        if (statistics.at<int>(i, cv::CC_STAT_AREA) < static_cast<int>(minPixels)) continue;
        const cv::Mat region = numbers == i;
        regions.push_back(RunLengthMask::fromBitmap(region.data, region.cols, region.rows));
    }
    return regions;
}
}  // namespace

std::string CPixelLabelsConverter::description() const
{
    return "labels of the scans' pixels, each connected region an object";
}

void CPixelLabelsConverter::declareOptions(OptionList& options)
{
    options.add("score", m_score, {0.01, 1}, "How sure labels are: the score of every region");
    options.add("min_pixels", m_minPixels, {1, 1e9}, "Smaller regions are left out [pixels]");
    declareClusteringOptions(options, m_clustering);
}

CObservationInstances::Ptr CPixelLabelsConverter::predict(
    const mrpt::obs::CObservation3DRangeScan& scan) const
{
    if (!scan.pixelLabels) return nullptr;
    const LabelImage labels(*scan.pixelLabels);
    auto predictions = CObservationInstances::Create();
    predictions->imageWidth = labels.columns;
    predictions->imageHeight = labels.rows;
    for (const auto& [label, name] : scan.pixelLabels->pixelLabelNames) {
        if (label >= LabelImage::MOST_LABELS) break;  // names are ordered by number
        for (RunLengthMask& mask : regionsOf(labels.pixelsOf(label), m_minPixels)) {
            InstancePrediction p;
            p.box = mask.boundingBox();
            p.mask = std::move(mask);
            p.categories = {{name, 1.F}};
            p.score = static_cast<float>(m_score);
            predictions->instances.push_back(std::move(p));
        }
    }
    return predictions;
}

std::vector<Opinion> CPixelLabelsConverter::convert(const RgbdFrame& frame,
                                                    const VoxelizedFrame& voxels) const
{
    return opinionsOf(frame, voxels, m_clustering);
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CPixelLabelsConverter> REGISTERED;
