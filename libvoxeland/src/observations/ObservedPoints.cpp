// SPDX-License-Identifier: BSD-3-Clause
#include "ObservedPoints.h"

#include "DepthImageCheck.h"
#include "DepthImageFile.h"
#include "PixelDirections.h"

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <cmath>

using mrpt::math::TPoint3D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationVelodyneScan;

namespace voxeland
{
namespace
{
/** Points in a sensor's frame that are finite and near enough. */
class PointCollector
{
 public:
    PointCollector(size_t most, double maxRange) : m_most(most), m_squaredRange(maxRange * maxRange)
    {
    }

    [[nodiscard]] size_t most() const { return m_most; }
    [[nodiscard]] std::vector<TPoint3D>& points() { return m_points; }

    void add(const TPoint3D& p)
    {
        const double squared = p.sqrNorm();
        if (!std::isfinite(squared)) return;
        if (m_squaredRange == 0 || squared <= m_squaredRange) m_points.push_back(p);
    }
    /** Adds at most most() of n points. \param point called as point(number), gives a point */
    template <typename PointOf>
    void addSome(size_t n, PointOf&& point)
    {
        const bool all = m_most == 0 || n <= m_most;
        // The golden ratio's multiples, modulo 1, are spread evenly and follow no row of an image.
        constexpr double GOLDEN = 0.6180339887498949;
        for (size_t i = 0; i < (all ? n : m_most); ++i) {
            const double share = std::fmod(static_cast<double>(i) * GOLDEN, 1.0);
            add(point(all ? i : static_cast<size_t>(share * static_cast<double>(n))));
        }
    }
    /** Adds some of the points given by three arrays. */
    template <typename Array>
    void addSome(const Array& x, const Array& y, const Array& z)
    {
        addSome(x.size(), [&](size_t i) { return TPoint3D(x[i], y[i], z[i]); });
    }

 private:
    size_t m_most;
    double m_squaredRange;
    std::vector<TPoint3D> m_points;
};

void collect(const CObservation2DRangeScan& scan, PointCollector& out)
{
    std::vector<size_t> valid;
    for (size_t i = 0; i < scan.getScanSize(); ++i)
        if (scan.getScanRangeValidity(i) && scan.getScanRange(i) < scan.maxRange)
            valid.push_back(i);
    out.addSome(valid.size(), [&](size_t i) {
        const double range = static_cast<double>(scan.getScanRange(valid[i]));
        const double angle = static_cast<double>(scan.getScanAngle(valid[i]));
        return TPoint3D(range * std::cos(angle), range * std::sin(angle), 0);
    });
}

void collectFromDepthImage(const CObservation3DRangeScan& scan, PointCollector& out)
{
    checkDepthImage(scan);
    const size_t columns = scan.cameraParams.ncols, rows = scan.cameraParams.nrows;
    const auto pixels = static_cast<double>(columns * rows);
    const size_t step =
        out.most() == 0
            ? 1
            : static_cast<size_t>(std::ceil(std::sqrt(pixels / static_cast<double>(out.most()))));
    PixelDirections directions(scan);
    for (size_t r = step / 2; r < rows; r += step) {
        directions.select(r);
        for (size_t c = step / 2; c < columns; c += step) {
            const auto steps = scan.rangeImage.data()[r * columns + c];
            if (steps == 0) continue;
            const double d = static_cast<double>(steps) * static_cast<double>(scan.rangeUnits);
            out.add({d * static_cast<double>(directions.x()[c]),
                     d * static_cast<double>(directions.y()[c]),
                     d * static_cast<double>(directions.z()[c])});
        }
    }
}

void collect(const CObservation3DRangeScan& scan, PointCollector& out)
{
    // load() reads the files each time.
    const bool missing = scan.hasRangeImage ? scan.rangeImage.size() == 0 : scan.points3D_x.empty();
    if (missing && scan.hasRangeImage) loadDepthImage(scan);
    if (missing && !scan.hasRangeImage) scan.load();
    if (scan.hasRangeImage)
        collectFromDepthImage(scan, out);
    else
        out.addSome(scan.points3D_x, scan.points3D_y, scan.points3D_z);
}

void collect(const CObservationPointCloud& cloud, PointCollector& out)
{
    if (!cloud.pointcloud) cloud.load();
    if (!cloud.pointcloud) return;
    const auto& points = *cloud.pointcloud;
    out.addSome(points.getPointsBufferRef_x(), points.getPointsBufferRef_y(),
                points.getPointsBufferRef_z());
}

void collect(const CObservationVelodyneScan& scan, PointCollector& out)
{
    // As MRPT's own maps do: the scan keeps the points made of its packets.
    if (scan.point_cloud.x.empty())
        const_cast<CObservationVelodyneScan&>(scan).generatePointCloud();
    out.addSome(scan.point_cloud.x, scan.point_cloud.y, scan.point_cloud.z);
}

/** Collects if the observation is of that class. */
template <typename Observation>
bool collectIf(const mrpt::obs::CObservation& observation, PointCollector& out)
{
    const auto* known = dynamic_cast<const Observation*>(&observation);
    if (known) collect(*known, out);
    return known != nullptr;
}
}  // namespace

bool hasPoints(const mrpt::obs::CObservation& observation)
{
    if (const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation))
        return scan->hasRangeImage || scan->hasPoints3D;
    return dynamic_cast<const CObservation2DRangeScan*>(&observation) != nullptr ||
           dynamic_cast<const CObservationPointCloud*>(&observation) != nullptr ||
           dynamic_cast<const CObservationVelodyneScan*>(&observation) != nullptr;
}

std::vector<TPoint3D> observedPoints(const mrpt::obs::CObservation& observation, size_t most,
                                     double maxRange)
{
    PointCollector collector(most, maxRange);
    collectIf<CObservation3DRangeScan>(observation, collector) ||
        collectIf<CObservation2DRangeScan>(observation, collector) ||
        collectIf<CObservationPointCloud>(observation, collector) ||
        collectIf<CObservationVelodyneScan>(observation, collector);
    const mrpt::poses::CPose3D sensor(observation.sensorPose());
    for (TPoint3D& p : collector.points()) p = sensor.composePoint(p);
    return std::move(collector.points());
}
}  // namespace voxeland
