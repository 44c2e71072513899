// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/ClusteringKeys.h"

namespace voxeland
{
void declareClusteringOptions(OptionList& list, ClusteringOptions& o)
{
    list.forExperts();
    list.add("cluster_cell", o.cell, {1, 100}, "Edge of the coarse grid's cells [voxels]");
    list.add("cluster_radius", o.radius, {1, 10},
             "Cells up to this far along each axis are neighbours [cells]");
    list.add(
        "cluster_density", o.density, {0, 1},
        "Core cells: this share of the points a surface facing the camera would have there ...");
    list.add("cluster_share", o.share, {0, 1},
             "... or this share of all the mask's points, whichever is less");
    list.add("min_points", o.min_points, {1, 1e6},
             "Masks with fewer valid depth pixels are left out [pixels]");
    // Of a mask's 3D points, all but the main cluster are left out.
    list.addAblation({{"clustering", o.enabled, "cluster"}});
}
}  // namespace voxeland
