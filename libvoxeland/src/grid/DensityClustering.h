// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <vector>

namespace voxeland
{
/** A cell of a grid with what lies in it. */
struct WeightedCell
{
    VoxelCoord coord;
    float weight = 1;  //!< e.g. number of points
    float coreWeight =
        1;  //!< weight within the neighbourhood (itself included) that makes it a core
};

/** Number of the cluster of cells that are in none. */
inline constexpr int NOISE = -1;

/** Density-based clustering (DBSCAN; Ester et al., 1996) on the cells of a grid instead of on raw
 *  points: the neighbourhood of a cell is the cube of +-`radius` cells around it. A cell reached
 *  from no core is noise.
 *
 *  Cost: O(cells * (2 radius + 1)^3). The result depends on the order of the cells only in which
 *  cluster claims a border cell: the first that reaches it.
 *
 *  \param cells distinct coordinates
 *  \return per cell the number of its cluster, from 0 in order of first core, or NOISE */
std::vector<int> clusterByDensity(const std::vector<WeightedCell>& cells, int radius);

/** The cluster with most weight (the first among equals), or NOISE if all cells are. */
int heaviestCluster(const std::vector<WeightedCell>& cells, const std::vector<int>& clusters);
}  // namespace voxeland
