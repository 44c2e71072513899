// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBinning.h"

#include "PixelDirections.h"
#include "base/vectorized.h"
#include "voxeland/grid/CoordHash.h"

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

/** The largest number, as some sensors give it for "nothing came back". */
constexpr uint16_t NO_RETURN = std::numeric_limits<uint16_t>::max();

/** What a pixel measured. */
enum Measured : int32_t
{
    NOTHING = 0,
    POINT = 1,
    BEYOND = 2  //!< something farther than the farthest depth used
};

/** One axis of a row of pixels. */
struct Axis
{
    std::vector<float> point;
    std::vector<int32_t> voxel;      //!< that holds the point
    std::vector<uint32_t> fraction;  //!< where in the voxel, of FRACTIONS

    explicit Axis(size_t n) : point(n), voxel(n), fraction(n) {}
};

/** One row of pixels as voxels and places within them. */
struct PixelRow
{
    std::array<Axis, 3> axes;
    std::vector<int32_t> measured;   //!< see Measured
    std::vector<uint8_t> startsRun;  //!< the pixel's voxel differs from the pixel's before

    explicit PixelRow(size_t n) : axes{Axis(n), Axis(n), Axis(n)}, measured(n), startsRun(n) {}

    [[nodiscard]] VoxelCoord voxelOf(size_t pixel) const
    {
        return {axes[0].voxel[pixel], axes[1].voxel[pixel], axes[2].voxel[pixel]};
    }
};

/** The runs of pixels of one voxel in a row: each one's first pixel, and the sums of all fractions
 *  before it, which may wrap: only differences count. One more entry is for the end of the row. */
struct RowRuns
{
    size_t count = 0;
    std::vector<uint32_t> first, x, y, z;

    explicit RowRuns(size_t pixels) : first(pixels + 1), x(pixels + 1), y(pixels + 1), z(pixels + 1)
    {
    }
};

/** Places in a voxel are whole numbers, whose sums are exact: so many steps an edge. */
constexpr float FRACTIONS = 65536;

VOXELAND_WITH_AVX2 void transform(const Unprojection& u, size_t n, const uint16_t* __restrict depth,
                                  const float* __restrict dx, const float* __restrict dy,
                                  const float* __restrict dz, float* __restrict x,
                                  float* __restrict y, float* __restrict z,
                                  int32_t* __restrict measured)
{
    const auto r = u.rotation;
    const auto o = u.origin;
    const float unit = u.unit, nearest = u.nearest, farthest = u.farthest;
    for (size_t c = 0; c < n; ++c) {
        const float metres = static_cast<float>(depth[c]) * unit;
        const int32_t isFar =
            static_cast<int32_t>(metres > farthest) & static_cast<int32_t>(depth[c] != NO_RETURN);
        measured[c] =
            (static_cast<int32_t>(metres >= nearest) & static_cast<int32_t>(metres <= farthest)) |
            isFar * BEYOND;
        const float d = measured[c] != NOTHING ? std::min(metres, farthest) : 0;
        const float ex = d * dx[c], ey = d * dy[c], ez = d * dz[c];
        x[c] = r[0] * ex + r[1] * ey + r[2] * ez + o[0];
        y[c] = r[3] * ex + r[4] * ey + r[5] * ez + o[1];
        z[c] = r[6] * ex + r[7] * ey + r[8] * ez + o[2];
    }
}

VOXELAND_WITH_AVX2 void split(size_t n, const float* __restrict in, int32_t* __restrict whole,
                              uint32_t* __restrict fraction)
{
    for (size_t c = 0; c < n; ++c) {
        const auto truncated = static_cast<int32_t>(in[c]);
        whole[c] = truncated - static_cast<int32_t>(in[c] < static_cast<float>(truncated));
        // Right below a boundary the rest may round to one.
        const float rest = in[c] - static_cast<float>(whole[c]);
        fraction[c] = static_cast<uint32_t>(
            std::min(static_cast<int32_t>(rest * FRACTIONS), static_cast<int32_t>(FRACTIONS) - 1));
    }
}

VOXELAND_WITH_AVX2 void findRuns(size_t n, const int32_t* __restrict i, const int32_t* __restrict j,
                                 const int32_t* __restrict k, const int32_t* __restrict measured,
                                 uint8_t* __restrict startsRun)
{
    for (size_t c = 1; c < n; ++c) {
        const int32_t change = (i[c] ^ i[c - 1]) | (j[c] ^ j[c - 1]) | (k[c] ^ k[c - 1]) |
                               (measured[c] ^ measured[c - 1]);
        startsRun[c] = static_cast<uint8_t>(change != 0);
    }
    startsRun[0] = 1;
}

void unproject(const Unprojection& u, const uint16_t* depth, const PixelDirections& directions,
               PixelRow& row)
{
    const size_t n = row.measured.size();
    auto& [x, y, z] = row.axes;
    transform(u, n, depth, directions.x(), directions.y(), directions.z(), x.point.data(),
              y.point.data(), z.point.data(), row.measured.data());
    for (Axis& a : row.axes) split(n, a.point.data(), a.voxel.data(), a.fraction.data());
    findRuns(n, x.voxel.data(), y.voxel.data(), z.voxel.data(), row.measured.data(),
             row.startsRun.data());
}

/** Range of the numbers of a depth image, those that say nothing left out. */
struct DepthRange
{
    uint16_t lessOne = NO_RETURN;  //!< the smallest, less one: 0 wraps to the largest of all
    uint16_t plusOne = 1;          //!< the largest, plus one: NO_RETURN wraps to 0
    uint64_t pixels = 0;
};

VOXELAND_WITH_AVX2 void extend(DepthRange& range, size_t n, const uint16_t* __restrict depth)
{
    uint16_t lessOne = range.lessOne, plusOne = range.plusOne, unknown = 0;
    for (size_t c = 0; c < n; ++c) {
        const auto less = static_cast<uint16_t>(depth[c] - 1);
        const auto plus = static_cast<uint16_t>(depth[c] + 1);
        lessOne = less < lessOne ? less : lessOne;
        plusOne = plus > plusOne ? plus : plusOne;
        unknown = static_cast<uint16_t>(unknown + (plus <= 1 ? 1 : 0));
    }
    range.lessOne = lessOne;
    range.plusOne = plusOne;
    range.pixels += n - unknown;
}

DepthsMet depthsMet(const DepthRange& range, double unit, const std::vector<HitVoxel>& hits)
{
    DepthsMet met;
    met.pixels = range.pixels;
    for (const HitVoxel& h : hits) met.used += h.points;
    if (range.pixels == 0) return met;
    met.nearest = (range.lessOne + 1) * unit;
    met.farthest = (range.plusOne - 1) * unit;
    return met;
}

void collectRuns(const PixelRow& row, RowRuns& runs)
{
    const auto pixels = static_cast<uint32_t>(row.startsRun.size());
    size_t run = 0;
    uint32_t x = 0, y = 0, z = 0;
    const auto write = [&](uint32_t pixel) {
        runs.first[run] = pixel;
        runs.x[run] = x;
        runs.y[run] = y;
        runs.z[run] = z;
    };
    // Written for every pixel, and kept if a run starts there: processors cannot predict where.
    for (uint32_t c = 0; c < pixels; ++c) {
        write(c);
        run += row.startsRun[c];
        x += row.axes[0].fraction[c];
        y += row.axes[1].fraction[c];
        z += row.axes[2].fraction[c];
    }
    write(pixels);
    runs.count = run;
}

/** Collects pixels of one kind in the voxels they fall in. */
class VoxelGrouping
{
 public:
    /** \param expected number of voxels to make room for */
    VoxelGrouping(const VoxelCoord& base, double resolution, size_t expected,
                  std::vector<HitVoxel>& hits)
        : m_base(base), m_resolution(resolution), m_hits(hits)
    {
        m_index.reserve(expected);
        m_hits.reserve(expected);
    }

    /** Adds a run of pixels. \return number of the voxel they are in */
    uint32_t add(const PixelRow& row, const RowRuns& runs, size_t run)
    {
        const uint32_t first = runs.first[run];
        const uint32_t hit = hitAt(row.voxelOf(first));
        HitVoxel& voxel = m_hits[hit];
        voxel.points += runs.first[run + 1] - first;
        voxel.centroid += TPoint3D(runs.x[run + 1] - runs.x[run], runs.y[run + 1] - runs.y[run],
                                   runs.z[run + 1] - runs.z[run]);
        return hit;
    }
    /** Turns sums of fractions into mean points. */
    void finish()
    {
        for (HitVoxel& h : m_hits) {
            const auto mean = [&](int32_t voxel, double sum) {
                constexpr double HALF = 0.5;  // fractions are rounded down
                return (voxel + (sum / h.points + HALF) / static_cast<double>(FRACTIONS)) *
                       m_resolution;
            };
            h.centroid = {mean(h.coord.x, h.centroid.x), mean(h.coord.y, h.centroid.y),
                          mean(h.coord.z, h.centroid.z)};
        }
    }

 private:
    uint32_t hitAt(const VoxelCoord& relative)
    {
        // The row before went through the same voxels: remember where they are.
        const uint64_t key = packed(relative);
        Found& found = m_found[lowBits<FOUND_BITS>(key)];
        if (found.key != key) {
            found = {key, m_index.insert(relative, static_cast<uint32_t>(m_hits.size()))};
            if (found.hit == m_hits.size()) m_hits.push_back({m_base + relative, 0, {0, 0, 0}});
        }
        return found.hit;
    }

    static constexpr int FOUND_BITS = 4;

    struct Found
    {
        uint64_t key = ~uint64_t{0};  //!< no voxel's
        uint32_t hit = 0;
    };

    VoxelCoord m_base;
    double m_resolution;
    std::vector<HitVoxel>& m_hits;
    CoordHash m_index;
    std::vector<Found> m_found =
        std::vector<Found>(size_t{1} << (3 * FOUND_BITS));  //!< by the coordinates' low bits
};
}  // namespace

BinnedPixels binPixels(const mrpt::obs::CObservation3DRangeScan& scan,
                       const mrpt::poses::CPose3D& sensorPose, double resolution,
                       const DepthLimits& limits)
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

    BinnedPixels grouped;
    std::vector<PixelRun>& found = grouped.runs;
    found.reserve(rows * columns / 2);
    PixelDirections directions(scan);
    VoxelGrouping hits(base, resolution, 1 << 12, grouped.hits);
    VoxelGrouping beyond(base, resolution, 0, grouped.beyond);  // most images have none
    DepthRange depths;
    PixelRow pixels(columns);
    RowRuns runs(columns);
    for (size_t row = 0; row < rows; ++row) {
        directions.select(row);
        const uint16_t* numbers = &scan.rangeImage(static_cast<int>(row), 0);
        extend(depths, columns, numbers);
        unproject(u, numbers, directions, pixels);
        collectRuns(pixels, runs);
        const size_t before = found.size();
        found.resize(before + runs.count);
        for (size_t r = 0; r < runs.count; ++r) {
            const uint32_t c = runs.first[r];
            PixelRun& run = found[before + r];
            run.first = static_cast<uint32_t>(row * columns) + c;
            if (pixels.measured[c] == POINT)
                run.hit = static_cast<int32_t>(hits.add(pixels, runs, r));
            else if (pixels.measured[c] == BEYOND)
                beyond.add(pixels, runs, r);
        }
    }
    found.push_back({static_cast<uint32_t>(rows * columns), PixelRun::NO_HIT});
    hits.finish();
    beyond.finish();
    grouped.depths = depthsMet(depths, static_cast<double>(scan.rangeUnits), grouped.hits);
    return grouped;
}
}  // namespace voxeland
