// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/VoxelizedFrame.h"

#include "voxeland/errors.h"
#include "voxeland/grid/CoordHash.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/Lie/SE.h>
#include <mrpt/system/datetime.h>

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
std::string nameOf(const mrpt::obs::CObservation& o)
{
    return "frame '" + o.sensorLabel + "' of " + mrpt::system::dateTimeToString(o.timestamp);
}

std::string sizeText(uint64_t columns, uint64_t rows)
{
    return std::to_string(columns) + "x" + std::to_string(rows);
}

void checkScan(const CObservation3DRangeScan& scan)
{
    if (!scan.hasRangeImage)
        throw InputError(nameOf(scan) + " has no depth image: only scans with one can be mapped");
    const auto& image = scan.rangeImage;
    const TCamera& camera = scan.cameraParams;
    if (image.cols() != static_cast<int>(camera.ncols) ||
        image.rows() != static_cast<int>(camera.nrows))
        throw InputError(
            nameOf(scan) + " has a depth image of " +
            sizeText(static_cast<uint64_t>(image.cols()), static_cast<uint64_t>(image.rows())) +
            " pixels but a calibration for " + sizeText(camera.ncols, camera.nrows) +
            ": correct its cameraParams");
    const bool valid = camera.fx() > 0 && camera.fy() > 0 && std::isfinite(camera.cx()) &&
                       std::isfinite(camera.cy()) && scan.rangeUnits > 0 &&
                       std::isfinite(scan.rangeUnits);
    if (!valid)
        throw InputError(nameOf(scan) +
                         " has an invalid calibration or depth unit: correct its "
                         "cameraParams and rangeUnits");
}

/** Camera the masks belong to: the colour one if there is one, otherwise the depth camera. */
const TCamera& maskCamera(const CObservation3DRangeScan& scan)
{
    const bool calibrated = scan.hasIntensityImage && scan.cameraParamsIntensity.fx() > 0;
    return calibrated ? scan.cameraParamsIntensity : scan.cameraParams;
}

void checkPredictions(const CObservation3DRangeScan& scan, const CObservationInstances& predictions)
{
    const TCamera& camera = maskCamera(scan);
    if (predictions.imageWidth == static_cast<int>(camera.ncols) &&
        predictions.imageHeight == static_cast<int>(camera.nrows))
        return;
    throw InputError(nameOf(scan) + " has predictions for images of " +
                     sizeText(static_cast<uint64_t>(predictions.imageWidth),
                              static_cast<uint64_t>(predictions.imageHeight)) +
                     " pixels but a colour camera of " + sizeText(camera.ncols, camera.nrows) +
                     ": make the predictions at the camera's size");
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

/** A pixel's coordinates from a direction (x/z, y/z), by the plumb-bob model of OpenCV and MRPT
 * with dist = k1 k2 p1 p2 k3. */
std::array<double, 2> projected(const TCamera& camera, double x, double y)
{
    const auto& d = camera.dist;
    const double r2 = x * x + y * y;
    const double radial = 1 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
    const double u = x * radial + 2 * d[2] * x * y + d[3] * (r2 + 2 * x * x);
    const double v = y * radial + d[2] * (r2 + 2 * y * y) + 2 * d[3] * x * y;
    return {camera.cx() + camera.fx() * u, camera.cy() + camera.fy() * v};
}

/** Collects points in voxels given by coordinates relative to a base voxel. */
class VoxelGrouping
{
 public:
    VoxelGrouping(const VoxelCoord& base, double resolution, std::vector<HitVoxel>& hits)
        : m_base(base), m_resolution(resolution), m_hits(hits)
    {
        m_index.reserve(1 << 13);
    }

    /** Adds a point; x, y, z in voxel edges from the base voxel's corner. \return its hit's number
     */
    int32_t add(const VoxelCoord& relative, float x, float y, float z)
    {
        if (!m_started || relative != m_current) startRun(relative);
        ++m_points;
        m_x += x;
        m_y += y;
        m_z += z;
        return static_cast<int32_t>(m_hit);
    }
    /** Turns sums into means. */
    void finish()
    {
        flush();
        for (size_t i = 0; i < m_hits.size(); ++i) {
            HitVoxel& h = m_hits[i];
            const double scale = m_resolution / h.points;
            h.centroid = {m_base.x * m_resolution + h.centroid.x * scale,
                          m_base.y * m_resolution + h.centroid.y * scale,
                          m_base.z * m_resolution + h.centroid.z * scale};
        }
    }

 private:
    // Neighbouring pixels mostly fall in the same voxel: sums of a run stay in registers.
    void startRun(const VoxelCoord& relative)
    {
        flush();
        m_current = relative;
        m_started = true;
        m_hit = m_index.insert(relative, static_cast<uint32_t>(m_hits.size()));
        if (m_hit == m_hits.size()) m_hits.push_back({m_base + relative, 0, {0, 0, 0}});
    }
    void flush()
    {
        if (m_points == 0) return;
        HitVoxel& h = m_hits[m_hit];
        h.points += m_points;
        h.centroid += TPoint3D(m_x, m_y, m_z);
        m_points = 0;
        m_x = m_y = m_z = 0;
    }

    VoxelCoord m_base, m_current;
    double m_resolution;
    std::vector<HitVoxel>& m_hits;
    CoordHash m_index;
    bool m_started = false;
    uint32_t m_hit = 0, m_points = 0;
    float m_x = 0, m_y = 0, m_z = 0;
};

/** Rounds down; unlike std::floor it vectorizes without SSE 4.1. */
inline int32_t roundedDown(float x)
{
    const auto truncated = static_cast<int32_t>(x);
    return truncated - static_cast<int32_t>(x < static_cast<float>(truncated));
}
}  // namespace

VoxelizedFrame::VoxelizedFrame(const RgbdFrame& frame, double resolution, const DepthLimits& limits)
    : m_resolution(resolution)
{
    const CObservation3DRangeScan& scan = *frame.scan;
    checkScan(scan);
    if (frame.instances) checkPredictions(scan, *frame.instances);
    const CPose3D sensorPose = frame.robotPose + scan.sensorPose;
    if (!isValidPose(sensorPose)) throw InputError(nameOf(scan) + " has an invalid pose");
    m_focalLength = scan.cameraParams.fx();
    m_origin = sensorPose.translation();
    groupPixels(scan, sensorPose, limits);
    if (frame.instances && !camerasCoincide(scan)) projectIntoColour(scan);
}

void VoxelizedFrame::groupPixels(const CObservation3DRangeScan& scan, const CPose3D& sensorPose,
                                 const DepthLimits& limits)
{
    const auto rows = static_cast<size_t>(scan.rangeImage.rows());
    const auto columns = static_cast<size_t>(scan.rangeImage.cols());
    m_hitOfPixel.resize(rows * columns);

    // Everything in voxel edges relative to the voxel of the optical centre: exact in float.
    const double edges = 1 / m_resolution;
    const VoxelCoord base = voxelOf(m_origin, edges);
    std::array<float, 9> r{};
    for (int i = 0; i < 9; ++i)
        r[static_cast<size_t>(i)] =
            static_cast<float>(sensorPose.getRotationMatrix()(i / 3, i % 3) * edges);
    const auto tx = static_cast<float>(m_origin.x * edges - base.x);
    const auto ty = static_cast<float>(m_origin.y * edges - base.y);
    const auto tz = static_cast<float>(m_origin.z * edges - base.z);

    const auto& directions = scan.get_unproj_lut();
    const float unit = scan.rangeUnits;
    const auto nearest = static_cast<float>(limits.min_depth);
    const auto farthest = static_cast<float>(limits.max_depth);
    VoxelGrouping grouping(base, m_resolution, m_hits);
    std::vector<float> x(columns), y(columns), z(columns);
    std::vector<int32_t> i(columns), j(columns), k(columns), valid(columns);
    for (size_t row = 0; row < rows; ++row) {
        const uint16_t* depth = &scan.rangeImage(static_cast<int>(row), 0);
        const float* dx = &directions.Kxs[row * columns];
        const float* dy = &directions.Kys[row * columns];
        const float* dz = &directions.Kzs[row * columns];
        for (size_t c = 0; c < columns; ++c) {
            const float d = static_cast<float>(depth[c]) * unit;
            valid[c] = static_cast<int32_t>(d >= nearest) & static_cast<int32_t>(d <= farthest);
            const float px = d * dx[c], py = d * dy[c], pz = d * dz[c];
            x[c] = r[0] * px + r[1] * py + r[2] * pz + tx;
            y[c] = r[3] * px + r[4] * py + r[5] * pz + ty;
            z[c] = r[6] * px + r[7] * py + r[8] * pz + tz;
            i[c] = roundedDown(x[c]);
            j[c] = roundedDown(y[c]);
            k[c] = roundedDown(z[c]);
        }
        int32_t* hit = &m_hitOfPixel[row * columns];
        for (size_t c = 0; c < columns; ++c)
            hit[c] = valid[c] != 0 ? grouping.add({i[c], j[c], k[c]}, x[c], y[c], z[c]) : NO_HIT;
    }
    grouping.finish();
}

void VoxelizedFrame::projectIntoColour(const CObservation3DRangeScan& scan)
{
    const TCamera& camera = maskCamera(scan);
    if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt)
        throw InputError(nameOf(scan) +
                         " has a fisheye colour camera: predictions can be used with "
                         "pinhole cameras only");
    const auto& directions = scan.get_unproj_lut();
    const CPose3D colourFromDepth = CPose3D() - scan.relativePoseIntensityWRTDepth;
    m_colourOfPixel.assign(m_hitOfPixel.size(), -1);
    for (size_t p = 0; p < m_hitOfPixel.size(); ++p) {
        if (m_hitOfPixel[p] == NO_HIT) continue;
        const double d =
            static_cast<double>(scan.rangeImage.data()[p]) * static_cast<double>(scan.rangeUnits);
        const TPoint3D inDepth(d * static_cast<double>(directions.Kxs[p]),
                               d * static_cast<double>(directions.Kys[p]),
                               d * static_cast<double>(directions.Kzs[p]));
        const TPoint3D inColour = colourFromDepth.composePoint(inDepth);
        if (!(inColour.z > 0)) continue;
        const auto [u, v] = projected(camera, inColour.x / inColour.z, inColour.y / inColour.z);
        const double column = std::floor(u + 0.5), row = std::floor(v + 0.5);
        if (column >= 0 && row >= 0 && column < camera.ncols && row < camera.nrows)
            m_colourOfPixel[p] = static_cast<int32_t>(row * camera.ncols + column);
    }
}

std::vector<std::pair<uint32_t, uint32_t>> VoxelizedFrame::pointsOf(const RunLengthMask& mask) const
{
    std::vector<uint32_t> count(m_hits.size(), 0);
    std::vector<std::pair<uint32_t, uint32_t>> points;
    const auto add = [&](int32_t hit, uint32_t n) {
        const auto h = static_cast<uint32_t>(hit);
        if (count[h] == 0) points.emplace_back(h, 0);
        count[h] += n;
    };
    if (m_colourOfPixel.empty()) {
        mask.forEachRun([&](uint32_t first, uint32_t last) {
            for (uint32_t p = first; p < last;) {
                const int32_t hit = m_hitOfPixel[p];
                const uint32_t start = p;
                while (++p < last && m_hitOfPixel[p] == hit) {
                }
                if (hit != NO_HIT) add(hit, p - start);
            }
        });
    } else {
        const std::vector<uint8_t> bitmap = mask.toBitmap();
        for (size_t p = 0; p < m_hitOfPixel.size(); ++p) {
            const int32_t colour = m_colourOfPixel[p];
            if (colour >= 0 && bitmap[static_cast<size_t>(colour)] != 0) add(m_hitOfPixel[p], 1);
        }
    }
    for (auto& [hit, n] : points) n = count[hit];
    return points;
}
}  // namespace voxeland
