// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"

#include <vector>

namespace voxeland
{
struct RgbdFrame;
class VoxelizedFrame;

/** Part of a geometric opinion: points of one of the frame's hit voxels. */
struct OpinionVoxel
{
    uint32_t hit = 0;  //!< number of the voxel in VoxelizedFrame::hits()
    float points = 0;  //!< number of the opinion's 3D points in it, > 0
};

/** The part of an image that an opinion was made from. */
struct ImageRegion
{
    PixelBox box;            //!< in the colour image [pixels]
    uint32_t area = 0;       //!< pixels of the object; 0: not known
    bool truncated = false;  //!< whether the object reaches the border of the image
};

/** The region a mask covers. */
ImageRegion regionOf(const RunLengthMask& mask);

/** A subjective opinion about one object (paper, "Making Subjective Opinions"). */
struct Opinion
{
    std::vector<OpinionVoxel> voxels;  //!< geometric level: where it is, each voxel once
    CategoryDistribution categories;   //!< semantic level: what it is
    float confidence = 0;              //!< xi: weight of the semantic opinion, in (0,1]
    int64_t track = InstancePrediction::NO_TRACK;  //!< detector's identity of the object, if any
    ImageRegion region{};  //!< where the image shows it, for those who look at it later
};

/** How the points of a mask are cleaned: density clustering on a coarse grid, of which the main
 *  cluster is kept. What density makes a core follows from range and resolution, so that small, far
 *  and thin objects survive. */
struct ClusteringOptions
{
    bool enabled = true;    //!< false: keep all points (the paper's ablation)
    int cell = 2;           //!< edge of the coarse cells [voxels], >= 1
    int radius = 1;         //!< neighbourhood of a coarse cell: +-radius cells, >= 1
    double density = 0.05;  //!< core: this share of the points that a surface facing the camera
                            //!< would have in the neighbourhood's cross section, in [0,1] ...
    double share =
        0.1;  //!< ... or this share of all the mask's points, whichever is less, in [0,1]
    uint32_t min_points = 20;  //!< masks with fewer valid depth points make no opinion
};

/** The geometric opinion of a mask: its points' main cluster; empty if nothing worth an opinion is
 * left. */
std::vector<OpinionVoxel> mainCluster(const VoxelizedFrame& frame, const RunLengthMask& mask,
                                      const ClusteringOptions& options);

/** An opinion for each of the frame's predictions that has categories, a positive score of at least
 * `minScore`, and a main cluster. */
std::vector<Opinion> opinionsOf(const RgbdFrame& frame, const VoxelizedFrame& voxels,
                                const ClusteringOptions& options, double minScore = 0);
}  // namespace voxeland
