// SPDX-License-Identifier: BSD-3-Clause
#include "PixelDirections.h"

#include <algorithm>
#include <mutex>

namespace voxeland
{
namespace
{
bool isPinhole(const mrpt::obs::CObservation3DRangeScan& scan)
{
    const auto& camera = scan.cameraParams;
    return scan.range_is_depth && camera.distortion != mrpt::img::DistortionModel::kannala_brandt &&
           std::all_of(camera.dist.begin(), camera.dist.end(), [](double d) { return d == 0; });
}

/** The directions of a camera with distortion. MRPT fills the table when a camera first asks for
 * it, unguarded, while frames are prepared in several threads. */
const mrpt::obs::CObservation3DRangeScan::unproject_LUT_t& unprojectionTable(
    const mrpt::obs::CObservation3DRangeScan& scan)
{
    static std::mutex filling;
    const std::lock_guard<std::mutex> lock(filling);
    return scan.get_unproj_lut();
}
}  // namespace

PixelDirections::PixelDirections(const mrpt::obs::CObservation3DRangeScan& scan)
    : m_camera(scan.cameraParams), m_pinhole(isPinhole(scan))
{
    if (!m_pinhole) {
        m_table = &unprojectionTable(scan);
        return;
    }
    m_x.assign(m_camera.ncols, 1.0f);
    m_z.resize(m_camera.ncols);
    for (uint32_t c = 0; c < m_camera.ncols; ++c)
        m_y.push_back(static_cast<float>((m_camera.cx() - c) / m_camera.fx()));
}

void PixelDirections::select(size_t row)
{
    m_row = row;
    if (!m_pinhole) return;
    const double z = (m_camera.cy() - static_cast<double>(row)) / m_camera.fy();
    std::fill(m_z.begin(), m_z.end(), static_cast<float>(z));
}
}  // namespace voxeland
