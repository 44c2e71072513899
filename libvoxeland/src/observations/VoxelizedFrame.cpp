// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/VoxelizedFrame.h"

#include "DepthImageCheck.h"
#include "MaskCamera.h"
#include "PixelDirections.h"
#include "Projection.h"
#include "VoxelBinning.h"
#include "base/sizeText.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/UnusableFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/Lie/SE.h>

#include <algorithm>
#include <array>
#include <cmath>

using mrpt::img::TCamera;
using mrpt::math::TPoint3D;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::poses::CPose3D;

namespace voxeland
{
namespace
{
/** \throws UnusableFrame unless they are of the scan's images */
void checkPredictions(const CObservation3DRangeScan& scan, const CObservationInstances& predictions)
{
    const std::string misfit = misfitOf(predictions, scan);
    if (!misfit.empty()) throw UnusableFrame(misfit);
}

/** Whether every depth pixel and the colour pixel of the same position look the same way. */
bool camerasCoincide(const CObservation3DRangeScan& scan)
{
    const TCamera& depth = scan.cameraParams;
    const TCamera& colour = maskCamera(scan);
    if (&depth == &colour) return true;
    const CPose3D registered(0, 0, 0, -M_PI / 2, 0, -M_PI / 2);
    const bool samePose =
        mrpt::poses::Lie::SE<3>::log(scan.relativePoseIntensityWRTDepth - registered).norm() < 1e-6;
    return samePose && depth.ncols == colour.ncols && depth.nrows == colour.nrows &&
           depth.intrinsicParams == colour.intrinsicParams && depth.dist == colour.dist;
}
}  // namespace

void DepthsMet::add(const DepthsMet& other)
{
    pixels += other.pixels;
    used += other.used;
    nearest = std::min(nearest, other.nearest);
    farthest = std::max(farthest, other.farthest);
}

VoxelizedFrame::VoxelizedFrame(const RgbdFrame& frame, double resolution, const DepthLimits& limits)
    : m_resolution(resolution)
{
    const CObservation3DRangeScan& scan = *frame.scan;
    checkDepthImage(scan);
    if (frame.instances) checkPredictions(scan, *frame.instances);
    const CPose3D sensorPose = frame.robotPose + scan.sensorPose;
    if (!isValidPose(sensorPose)) throw UnusableFrame(frameName(scan) + " has an invalid pose");
    m_focalLength = scan.cameraParams.fx();
    m_origin = sensorPose.translation();
    BinnedPixels grouped = binPixels(scan, sensorPose, resolution, limits);
    m_hits = std::move(grouped.hits);
    m_beyond = std::move(grouped.beyond);
    m_runs = std::move(grouped.runs);
    m_depths = grouped.depths;
    m_isProjected = frame.instances && !camerasCoincide(scan);
    if (m_isProjected) projectIntoColour(scan);
    const TCamera& masked = m_isProjected ? maskCamera(scan) : scan.cameraParams;
    m_maskWidth = static_cast<int>(masked.ncols);
    m_maskHeight = static_cast<int>(masked.nrows);
}

void VoxelizedFrame::projectIntoColour(const CObservation3DRangeScan& scan)
{
    const TCamera& camera = maskCamera(scan);
    if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt)
        throw InputError(frameName(scan) +
                         " has a fisheye colour camera: predictions can be used with "
                         "pinhole cameras only");
    PixelDirections directions(scan);
    const size_t columns = scan.cameraParams.ncols;
    const CPose3D colourFromDepth = CPose3D() - scan.relativePoseIntensityWRTDepth;
    m_colourOfPixel.assign(m_runs.back().first, -1);
    size_t selected = scan.cameraParams.nrows;
    forEachHitRun([&](uint32_t, uint32_t first, uint32_t last) {
        if (first / columns != selected) directions.select(selected = first / columns);
        for (size_t p = first; p < last; ++p) {
            const size_t c = p % columns;
            const double d = static_cast<double>(scan.rangeImage.data()[p]) *
                             static_cast<double>(scan.rangeUnits);
            const TPoint3D inDepth(d * static_cast<double>(directions.x()[c]),
                                   d * static_cast<double>(directions.y()[c]),
                                   d * static_cast<double>(directions.z()[c]));
            const TPoint3D inColour = colourFromDepth.composePoint(inDepth);
            if (!(inColour.z > 0)) continue;
            const auto [u, v] = projected(camera, inColour.x / inColour.z, inColour.y / inColour.z);
            const double column = std::floor(u + 0.5), row = std::floor(v + 0.5);
            if (column >= 0 && row >= 0 && column < camera.ncols && row < camera.nrows)
                m_colourOfPixel[p] = static_cast<int32_t>(row * camera.ncols + column);
        }
    });
}

template <typename F>
void VoxelizedFrame::forEachHitRun(F&& f) const
{
    for (size_t r = 0; r + 1 < m_runs.size(); ++r)
        if (m_runs[r].hit != PixelRun::NO_HIT)
            f(static_cast<uint32_t>(m_runs[r].hit), m_runs[r].first, m_runs[r + 1].first);
}

std::vector<std::pair<uint32_t, uint32_t>> VoxelizedFrame::pointsOf(const RunLengthMask& mask) const
{
    if (mask.width() != m_maskWidth || mask.height() != m_maskHeight)
        throw InputError("a prediction has a mask of " + sizeText(mask.width(), mask.height()) +
                         " pixels but its image has " + sizeText(m_maskWidth, m_maskHeight) +
                         ": make the masks at the image's size");
    std::vector<uint32_t> count(m_hits.size(), 0);
    std::vector<std::pair<uint32_t, uint32_t>> points;
    const auto add = [&](uint32_t hit, uint32_t n) {
        if (count[hit] == 0) points.emplace_back(hit, 0);
        count[hit] += n;
    };
    if (!m_isProjected) {
        auto run = m_runs.begin();
        mask.forEachRun([&](uint32_t first, uint32_t last) {
            // The first run to look at lies no more runs ahead than pixels.
            const auto ahead = std::min<std::ptrdiff_t>(first - run->first + 1, m_runs.end() - run);
            run = std::upper_bound(run, run + ahead, first,
                                   [](uint32_t p, const PixelRun& r) { return p < r.first; });
            for (--run; run->first < last; ++run)
                if (run->hit != PixelRun::NO_HIT)
                    add(static_cast<uint32_t>(run->hit),
                        std::min(last, (run + 1)->first) - std::max(first, run->first));
            --run;  // the mask's next run may begin in it
        });
    } else {
        const std::vector<uint8_t> bitmap = mask.toBitmap();
        forEachHitRun([&](uint32_t hit, uint32_t first, uint32_t last) {
            for (uint32_t p = first; p < last; ++p) {
                const int32_t colour = m_colourOfPixel[p];
                if (colour >= 0 && bitmap[static_cast<size_t>(colour)] != 0) add(hit, 1);
            }
        });
    }
    for (auto& [hit, n] : points) n = count[hit];
    return points;
}
}  // namespace voxeland
