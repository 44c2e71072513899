// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"
#include "voxeland/observations/RgbdFrame.h"

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace voxeland
{
/** A voxel in which a frame measured points. */
struct HitVoxel
{
    VoxelCoord coord;
    uint32_t points = 0;            //!< number of depth pixels in it
    mrpt::math::TPoint3D centroid;  //!< mean of those points, in the map's frame [m]
};

/** What a depth image measured, used or not. */
struct DepthsMet
{
    uint64_t pixels = 0;  //!< with a depth
    uint64_t used = 0;    //!< of those, within the limits
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;  //!< [m]

    void add(const DepthsMet& other);
};

/** Successive depth pixels of a row in one voxel, up to the next run. */
struct PixelRun
{
    static constexpr int32_t NO_HIT = -1;

    uint32_t first = 0;    //!< number of the first pixel, row-major
    int32_t hit = NO_HIT;  //!< number of the hit voxel; NO_HIT: pixels without a point
};

/** Which depths to use. They limit what the scan's range image holds: the depth along the optical
 * axis, or the distance from the camera for scans with `range_is_depth = false`. What lies farther
 * is no surface of the map, but shows that there is none up to `max_depth`. */
struct DepthLimits
{
    double min_depth = 0.3;  //!< nearest used [m]
    double max_depth = 4.0;  //!< farthest used [m]
};

/** The pixels of a depth image grouped by the voxel their 3D points fall in: everything after works
 * per voxel (some thousands), not per pixel (some hundred thousands). Depends on the frame alone,
 * not on any map. */
class VoxelizedFrame
{
 public:
    /** Unprojects (with lens distortion), transforms and groups a frame's depth pixels.
     *  \param resolution voxel edge [m]
     *  \throws InputError, naming the frame, for scans without a depth image or with invalid
     *  calibration or units, and for predictions made for images of another size */
    VoxelizedFrame(const RgbdFrame& frame, double resolution, const DepthLimits& limits);

    [[nodiscard]] double resolution() const { return m_resolution; }
    /** Optical centre of the depth camera in the map's frame [m]. */
    [[nodiscard]] const mrpt::math::TPoint3D& origin() const { return m_origin; }
    /** Focal length of the depth camera [pixels]. */
    [[nodiscard]] double focalLength() const { return m_focalLength; }
    /** The voxels hit, in row-major order of their first pixel. */
    [[nodiscard]] const std::vector<HitVoxel>& hits() const { return m_hits; }
    /** Where the rays of pixels that measured more than `max_depth` reach it, by voxel. 0 and
     * 65535 are no measurements. */
    [[nodiscard]] const std::vector<HitVoxel>& beyond() const { return m_beyond; }
    [[nodiscard]] const DepthsMet& depths() const { return m_depths; }

    /** How many depth pixels of a mask fall in each hit voxel.
     *  \param mask of the colour image, or of the depth image where the frame has no predictions
     *  \return pairs of the hit's number and that count, in order of first pixel
     *  \throws InputError for a mask of another size than that image's */
    [[nodiscard]] std::vector<std::pair<uint32_t, uint32_t>> pointsOf(
        const RunLengthMask& mask) const;

 private:
    /** Calls f(hit, first, last) for each run of pixels [first, last) with points. */
    template <typename F>
    void forEachHitRun(F&& f) const;
    void projectIntoColour(const mrpt::obs::CObservation3DRangeScan& scan);

    double m_resolution;
    double m_focalLength = 0;
    int m_maskWidth = 0, m_maskHeight = 0;  //!< size of the image that masks are of [pixels]
    mrpt::math::TPoint3D m_origin;
    std::vector<HitVoxel> m_hits, m_beyond;
    DepthsMet m_depths;
    std::vector<PixelRun> m_runs;          //!< all depth pixels; the last one starts after them
    bool m_isProjected = false;            //!< whether depth and colour pixels differ
    std::vector<int32_t> m_colourOfPixel;  //!< if so: depth pixel -> colour pixel or -1
};
}  // namespace voxeland
