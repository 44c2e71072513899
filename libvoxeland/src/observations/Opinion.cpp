// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/Opinion.h"

#include "grid/DensityClustering.h"
#include "voxeland/grid/CoordHash.h"
#include "voxeland/observations/VoxelizedFrame.h"

#include <algorithm>
#include <numeric>

namespace voxeland
{
namespace
{
int32_t dividedDown(int32_t a, int32_t b)
{
    return a / b - static_cast<int32_t>(a % b < 0);
}

/** The coarse cells some hit voxels lie in. */
struct CoarseCells
{
    std::vector<WeightedCell> cells;
    std::vector<uint32_t> cellOfVoxel;

    CoarseCells(const VoxelizedFrame& frame, const std::vector<OpinionVoxel>& voxels, int edge)
    {
        CoordHash index;
        index.reserve(voxels.size());
        for (const OpinionVoxel& v : voxels) {
            const VoxelCoord c = frame.hits()[v.hit].coord;
            const VoxelCoord coarse = {dividedDown(c.x, edge), dividedDown(c.y, edge),
                                       dividedDown(c.z, edge)};
            const uint32_t i = index.insert(coarse, static_cast<uint32_t>(cells.size()));
            if (i == cells.size()) cells.push_back({coarse, 0, 0});
            cells[i].weight += v.points;
            cellOfVoxel.push_back(i);
        }
    }
};

/** Points that a neighbourhood of coarse cells would get from a surface facing the camera through
 * it. */
double pointsOfFacingSurface(const VoxelizedFrame& frame, const WeightedCell& cell,
                             const ClusteringOptions& options)
{
    const double edge = options.cell * frame.resolution();
    const auto center = voxelCenter<mrpt::math::TPoint3D>(cell.coord, edge);
    const double width = edge * (2 * options.radius + 1);
    const double pixels = frame.focalLength() * width / (center - frame.origin()).norm();
    return pixels * pixels;
}
}  // namespace

ImageRegion regionOf(const RunLengthMask& mask)
{
    ImageRegion region;
    region.box = mask.boundingBox();
    region.area = static_cast<uint32_t>(mask.area());
    const PixelBox& b = region.box;
    region.truncated =
        b.x == 0 || b.y == 0 || b.x + b.width == mask.width() || b.y + b.height == mask.height();
    return region;
}

std::vector<OpinionVoxel> mainCluster(const VoxelizedFrame& frame, const RunLengthMask& mask,
                                      const ClusteringOptions& options)
{
    std::vector<OpinionVoxel> voxels;
    uint64_t points = 0;
    for (const auto& [hit, n] : frame.pointsOf(mask)) {
        voxels.push_back({hit, static_cast<float>(n)});
        points += n;
    }
    if (points < options.min_points) return {};
    if (!options.enabled) return voxels;

    CoarseCells coarse(frame, voxels, options.cell);
    for (WeightedCell& c : coarse.cells)
        c.coreWeight =
            static_cast<float>(std::min(options.density * pointsOfFacingSurface(frame, c, options),
                                        options.share * static_cast<double>(points)));
    const std::vector<int> clusters = clusterByDensity(coarse.cells, options.radius);
    const int main = heaviestCluster(coarse.cells, clusters);
    if (main == NOISE) return {};
    std::vector<OpinionVoxel> kept;
    for (size_t i = 0; i < voxels.size(); ++i)
        if (clusters[coarse.cellOfVoxel[i]] == main) kept.push_back(voxels[i]);
    return kept;
}

std::vector<Opinion> opinionsOf(const RgbdFrame& frame, const VoxelizedFrame& voxels,
                                const ClusteringOptions& options, double minScore)
{
    std::vector<Opinion> opinions;
    if (!frame.instances) return opinions;
    for (const InstancePrediction& p : frame.instances->instances) {
        const bool usable = p.score > 0 && static_cast<double>(p.score) >= minScore;
        if (!usable || p.categories.empty()) continue;
        auto points = mainCluster(voxels, p.mask, options);
        if (!points.empty())
            opinions.push_back(
                {std::move(points), p.categories, p.score, p.track, regionOf(p.mask)});
    }
    return opinions;
}
}  // namespace voxeland
