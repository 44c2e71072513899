// SPDX-License-Identifier: BSD-3-Clause
#include "FramePairs.h"

#include "OpticalPose.h"
#include "observations/PixelDirections.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/Lie/SO.h>

#include <algorithm>
#include <array>
#include <optional>

namespace voxeland
{
namespace
{
constexpr size_t FIRST_FRAMES = 24;
constexpr std::array<size_t, 5> FRAMES_LATER = {1, 3, 10, 30, 80};
constexpr double MAX_TURN = 30 * M_PI / 180;
constexpr size_t COLUMNS_SAMPLED = 40;

struct PosedScan
{
    std::shared_ptr<const mrpt::obs::CObservation3DRangeScan> scan;
    mrpt::poses::CPose3D pose;  //!< camera-to-world, of optical axes
};

std::vector<SampledPixel> samplePixels(const mrpt::obs::CObservation3DRangeScan& scan)
{
    std::vector<SampledPixel> pixels;
    PixelDirections directions(scan);
    const size_t columns = scan.cameraParams.ncols, rows = scan.cameraParams.nrows;
    const size_t step = std::max<size_t>(1, columns / COLUMNS_SAMPLED);
    for (size_t row = step / 2; row < rows; row += step) {
        directions.select(row);
        for (size_t c = step / 2; c < columns; c += step) {
            const auto value = scan.rangeImage(static_cast<int>(row), static_cast<int>(c));
            if (value == 0) continue;
            // From MRPT's axes of a camera (x forward, y left, z up) to optical ones.
            pixels.push_back(
                {{-static_cast<double>(directions.y()[c]), -static_cast<double>(directions.z()[c])},
                 static_cast<double>(value)});
        }
    }
    return pixels;
}

/** Reads frames, counting. */
class SampleReader
{
 public:
    SampleReader(const RgbdDatasetReader& dataset, const std::function<void(size_t)>& progress)
        : m_dataset(dataset), m_progress(progress)
    {
    }

    /** The frame, or nothing if it is unusable. */
    std::optional<PosedScan> read(size_t index)
    {
        m_progress(++m_read);
        try {
            const RgbdRecord record = m_dataset.load(index);
            return PosedScan{record.scan, opticalPose(*record.robotPose)};
        } catch (const UnusableFrame& e) {
            ++m_unusable[e.what()];
            return std::nullopt;
        }
    }

    /** Number of frames that could not be read, by reason. */
    [[nodiscard]] const std::map<std::string, size_t>& unusable() const { return m_unusable; }

 private:
    const RgbdDatasetReader& m_dataset;
    const std::function<void(size_t)>& m_progress;
    size_t m_read = 0;
    std::map<std::string, size_t> m_unusable;
};

double turnBetween(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b)
{
    return mrpt::poses::Lie::SO<3>::log((b - a).getRotationMatrix()).norm();
}
}  // namespace

FrameSample pickFramePairs(const RgbdDatasetReader& dataset,
                           const std::function<void(size_t read)>& progress)
{
    const std::vector<size_t> indices = dataset.selected();
    const size_t step = std::max<size_t>(1, indices.size() / FIRST_FRAMES);
    SampleReader reader(dataset, progress);
    FrameSample sample;
    for (size_t i = 0; i < indices.size(); i += step) {
        const auto first = reader.read(indices[i]);
        if (!first) continue;
        std::optional<PosedScan> farthest;
        double distance = 0;
        for (const size_t later : FRAMES_LATER) {
            if (i + later >= indices.size()) break;
            const auto second = reader.read(indices[i + later]);
            if (!second || turnBetween(first->pose, second->pose) > MAX_TURN) continue;
            const double d = first->pose.distanceTo(second->pose);
            if (d <= distance) continue;
            distance = d;
            farthest = second;
        }
        if (farthest)
            sample.pairs.push_back(
                {samplePixels(*first->scan), farthest->scan, first->pose, farthest->pose});
    }
    sample.unusable = reader.unusable();
    return sample;
}
}  // namespace voxeland
