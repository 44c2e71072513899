// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "grid/VoxelFaces.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <opencv2/core.hpp>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace voxeland
{
/** One voxel to draw. */
struct SceneVoxel
{
    cv::Vec3f center;                         //!< in the gravity-aligned frame [m]
    const VoxelEvidence* evidence = nullptr;  //!< in the map
    instance_id_t winner = UNKNOWN_INSTANCE;
    uint8_t exposedFaces = 0;  //!< bit i: FACES[i] is not covered by a voxel of the same kind

    [[nodiscard]] bool isObject() const { return winner != UNKNOWN_INSTANCE; }
};

/** The voxels of a map that a picture shows, in a gravity-aligned frame. Points into the map, which
 * must outlive it. */
class VoxelScene
{
 public:
    VoxelScene(const SemanticVoxelMap& map, const GravityAlignedFrame& frame);
    /** One instance and what is around it: no other voxel counts as an object. Empty if the
     * instance has no voxels. Cost: the voxels in its box, whatever the size of the map. */
    VoxelScene(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
               instance_id_t instance);

    [[nodiscard]] const std::vector<SceneVoxel>& voxels() const { return m_voxels; }
    [[nodiscard]] double resolution() const { return m_resolution; }
    /** Unit vectors of the map's x, y, z in the gravity-aligned frame. */
    [[nodiscard]] const std::array<cv::Vec3f, 3>& mapAxes() const { return m_axes; }
    /** A point of the map's frame in the gravity-aligned frame. */
    [[nodiscard]] cv::Vec3f toLevel(const mrpt::math::TPoint3D& inMap) const;
    /** Box around the voxels but for a few strays, in the gravity-aligned frame [m]. */
    [[nodiscard]] const cv::Vec3f& min() const { return m_min; }
    [[nodiscard]] const cv::Vec3f& max() const { return m_max; }

 private:
    /** As what an occupied voxel is shown, if it is. */
    using Shown =
        std::function<std::optional<instance_id_t>(const VoxelCoord&, const VoxelEvidence&)>;

    /** Nothing, in a gravity-aligned frame. */
    VoxelScene(double resolution, const GravityAlignedFrame& frame);
    /** Up to which height voxels of *unknown* are shown, see exportViews(). */
    [[nodiscard]] float cutHeight(const SemanticVoxelMap& map) const;
    [[nodiscard]] cv::Vec3f centerOf(const VoxelCoord& v) const;
    [[nodiscard]] bool isInBounds(const cv::Vec3f& point) const;
    /** The blocks of a map that the bounds may touch, in the order of its voxels. Cost: the blocks
     * there, or those of the map where it has fewer. */
    [[nodiscard]] std::vector<VoxelCoord> blocksInBounds(const SemanticVoxelMap& map) const;
    void add(const SemanticVoxelMap& map, const VoxelCoord& v, const VoxelEvidence& evidence,
             const Shown& shown);
    /** \param blocks of which some may not be in the map */
    template <typename Coords>
    void addBlocks(const SemanticVoxelMap& map, const Coords& blocks, const Shown& shown);
    void findBounds();

    double m_resolution;
    GravityAlignedFrame m_frame;
    std::array<cv::Vec3f, 3> m_axes;
    std::vector<SceneVoxel> m_voxels;
    cv::Vec3f m_min{0, 0, 0}, m_max{1, 1, 1};
};
}  // namespace voxeland
