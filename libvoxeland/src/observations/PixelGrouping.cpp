// SPDX-License-Identifier: BSD-3-Clause
#include "PixelGrouping.h"

#include "voxeland/grid/CoordHash.h"
#include "voxeland/observations/PixelDirections.h"
#include "voxeland/vectorized.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <array>
#include <limits>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
/** Unprojects depth pixels into voxel edges relative to a base voxel, where float is exact enough.
 */
struct Unprojection
{
    std::array<float, 9> rotation{};  //!< row-major, times edges per metre
    std::array<float, 3> origin{};    //!< optical centre
    float unit = 0;                   //!< metres per depth step
    float nearest = 0, farthest = 0;  //!< depths used [m]
};

/** One row of pixels as points and voxels. */
struct PixelRow
{
    std::vector<float> x, y, z;
    std::vector<int32_t> i, j, k, valid;
    std::vector<uint8_t> startsRun;  //!< the pixel's voxel differs from the pixel's before

    explicit PixelRow(size_t n) : x(n), y(n), z(n), i(n), j(n), k(n), valid(n), startsRun(n + 1) {}
};

VOXELAND_WITH_AVX2 void transform(const Unprojection& u, size_t n, const uint16_t* __restrict depth,
                                  const float* __restrict dx, const float* __restrict dy,
                                  const float* __restrict dz, float* __restrict x,
                                  float* __restrict y, float* __restrict z,
                                  int32_t* __restrict valid)
{
    const auto r = u.rotation;
    const auto o = u.origin;
    const float unit = u.unit, nearest = u.nearest, farthest = u.farthest;
    for (size_t c = 0; c < n; ++c) {
        const float d = static_cast<float>(depth[c]) * unit;
        valid[c] = static_cast<int32_t>(d >= nearest) & static_cast<int32_t>(d <= farthest);
        const float ex = d * dx[c], ey = d * dy[c], ez = d * dz[c];
        x[c] = r[0] * ex + r[1] * ey + r[2] * ez + o[0];
        y[c] = r[3] * ex + r[4] * ey + r[5] * ez + o[1];
        z[c] = r[6] * ex + r[7] * ey + r[8] * ez + o[2];
    }
}

VOXELAND_WITH_AVX2 void roundDown(size_t n, const float* __restrict in, int32_t* __restrict out)
{
    for (size_t c = 0; c < n; ++c) {
        const auto truncated = static_cast<int32_t>(in[c]);
        out[c] = truncated - static_cast<int32_t>(in[c] < static_cast<float>(truncated));
    }
}

VOXELAND_WITH_AVX2 void findRuns(size_t n, const int32_t* __restrict i, const int32_t* __restrict j,
                                 const int32_t* __restrict k, const int32_t* __restrict valid,
                                 uint8_t* __restrict startsRun)
{
    for (size_t c = 1; c < n; ++c) {
        const int32_t change =
            (i[c] ^ i[c - 1]) | (j[c] ^ j[c - 1]) | (k[c] ^ k[c - 1]) | (valid[c] ^ valid[c - 1]);
        startsRun[c] = static_cast<uint8_t>(change != 0);
    }
    startsRun[0] = startsRun[n] = 1;
}

void unproject(const Unprojection& u, const uint16_t* depth, const PixelDirections& directions,
               PixelRow& row)
{
    const size_t n = row.x.size();
    transform(u, n, depth, directions.x(), directions.y(), directions.z(), row.x.data(),
              row.y.data(), row.z.data(), row.valid.data());
    roundDown(n, row.x.data(), row.i.data());
    roundDown(n, row.y.data(), row.j.data());
    roundDown(n, row.z.data(), row.k.data());
    findRuns(n, row.i.data(), row.j.data(), row.k.data(), row.valid.data(), row.startsRun.data());
}

/** Collects pixels in the voxels they fall in. */
class VoxelGrouping
{
 public:
    VoxelGrouping(const VoxelCoord& base, double resolution, std::vector<HitVoxel>& hits)
        : m_base(base), m_resolution(resolution), m_hits(hits)
    {
        m_index.reserve(1 << 13);
    }

    /** Adds a row of pixels. \param hitOfPixel receives each pixel's hit, or NO_HIT */
    void add(const PixelRow& row, int32_t* hitOfPixel)
    {
        // Neighbouring pixels mostly fall in the same voxel: one look-up serves a whole run.
        for (size_t c = 0, n = row.x.size(); c < n;) {
            if (row.valid[c] == 0) {
                do hitOfPixel[c] = VoxelizedFrame::NO_HIT;
                while (row.startsRun[++c] == 0);
                continue;
            }
            const uint32_t hit = hitAt({row.i[c], row.j[c], row.k[c]});
            const size_t first = c;
            float x = 0, y = 0, z = 0;
            do {
                x += row.x[c];
                y += row.y[c];
                z += row.z[c];
                hitOfPixel[c] = static_cast<int32_t>(hit);
            } while (row.startsRun[++c] == 0);
            m_hits[hit].points += static_cast<uint32_t>(c - first);
            m_hits[hit].centroid += TPoint3D(x, y, z);
        }
    }
    /** Turns sums into means. */
    void finish()
    {
        for (HitVoxel& h : m_hits) {
            const double scale = m_resolution / h.points;
            h.centroid = {m_base.x * m_resolution + h.centroid.x * scale,
                          m_base.y * m_resolution + h.centroid.y * scale,
                          m_base.z * m_resolution + h.centroid.z * scale};
        }
    }

 private:
    uint32_t hitAt(const VoxelCoord& relative)
    {
        // The row before went through the same voxels: remember where they are.
        Found& found = m_found[static_cast<size_t>(cellOf(relative))];
        if (found.hit == CoordHash::NONE || found.coord != relative) {
            found = {relative, m_index.insert(relative, static_cast<uint32_t>(m_hits.size()))};
            if (found.hit == m_hits.size()) m_hits.push_back({m_base + relative, 0, {0, 0, 0}});
        }
        return found.hit;
    }

    struct Found
    {
        VoxelCoord coord;
        uint32_t hit = CoordHash::NONE;
    };

    VoxelCoord m_base;
    double m_resolution;
    std::vector<HitVoxel>& m_hits;
    CoordHash m_index;
    std::array<Found, BLOCK_CELLS> m_found;  //!< by the low bits of the coordinates
};
}  // namespace

std::vector<int32_t> groupPixels(const mrpt::obs::CObservation3DRangeScan& scan,
                                 const mrpt::poses::CPose3D& sensorPose, double resolution,
                                 const DepthLimits& limits, std::vector<HitVoxel>& hits)
{
    const auto rows = static_cast<size_t>(scan.rangeImage.rows());
    const auto columns = static_cast<size_t>(scan.rangeImage.cols());
    const TPoint3D origin = sensorPose.translation();
    const double edges = 1 / resolution;
    const VoxelCoord base = voxelOf(origin, edges);
    Unprojection u;
    for (int i = 0; i < 9; ++i)
        u.rotation[static_cast<size_t>(i)] =
            static_cast<float>(sensorPose.getRotationMatrix()(i / 3, i % 3) * edges);
    u.origin = {static_cast<float>(origin.x * edges - base.x),
                static_cast<float>(origin.y * edges - base.y),
                static_cast<float>(origin.z * edges - base.z)};
    u.unit = scan.rangeUnits;
    // Zero means not measured, even where there is no lower limit.
    u.nearest = std::max(static_cast<float>(limits.min_depth), std::numeric_limits<float>::min());
    u.farthest = static_cast<float>(limits.max_depth);

    std::vector<int32_t> hitOfPixel(rows * columns);
    PixelDirections directions(scan);
    VoxelGrouping grouping(base, resolution, hits);
    PixelRow pixels(columns);
    for (size_t row = 0; row < rows; ++row) {
        directions.select(row);
        unproject(u, &scan.rangeImage(static_cast<int>(row), 0), directions, pixels);
        grouping.add(pixels, &hitOfPixel[row * columns]);
    }
    grouping.finish();
    return hitOfPixel;
}
}  // namespace voxeland
