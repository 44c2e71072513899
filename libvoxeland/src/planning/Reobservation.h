// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "CameraPlacement.h"

#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** Something worth another look. */
struct ReobservationTarget
{
    std::optional<instance_id_t> instance;  //!< none: a region
    std::string category;                   //!< of the instance
    double uncertainty = 0;         //!< H(C_k) of the instance, or mean H(I_v) of the region [nat]
    size_t voxels = 0;              //!< occupied ones
    mrpt::math::TPoint3D center;    //!< their mean [m]
    std::vector<CameraPose> poses;  //!< where to look from, the best first; may be empty
};

/** What is worth another look, the most uncertain first: instances by how undecided their category
 *  is, and regions (the map's blocks, 8 voxels wide) by how undecided it is which instances their
 *  voxels belong to. Instances of less than 5 voxels, and regions with less than 20 that some
 *  instance has a part in, are left out.
 *  \param most how many to give */
std::vector<ReobservationTarget> planReobservation(const SemanticVoxelMap& map,
                                                   const GravityAlignedFrame& frame,
                                                   const CarriedCamera& camera, size_t most = 10);
}  // namespace voxeland
