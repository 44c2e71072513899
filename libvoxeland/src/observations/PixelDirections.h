// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <vector>

namespace voxeland
{
/** Direction of each pixel per unit of depth, in the depth camera's frame (x forward, y left, z
 * up). A pinhole camera's come from one row and one column of numbers: a table of all pixels, as
 * lens distortion needs, does not fit in the cache. */
class PixelDirections
{
 public:
    explicit PixelDirections(const mrpt::obs::CObservation3DRangeScan& scan);

    /** Goes to a row; x(), y() and z() then point to one value a column. */
    void select(size_t row);
    [[nodiscard]] const float* x() const { return m_pinhole ? m_x.data() : at(m_table->Kxs); }
    [[nodiscard]] const float* y() const { return m_pinhole ? m_y.data() : at(m_table->Kys); }
    [[nodiscard]] const float* z() const { return m_pinhole ? m_z.data() : at(m_table->Kzs); }

 private:
    template <typename Table>
    [[nodiscard]] const float* at(const Table& table) const
    {
        return &table[m_row * m_camera.ncols];
    }

    const mrpt::img::TCamera& m_camera;
    bool m_pinhole;
    size_t m_row = 0;
    std::vector<float> m_x, m_y, m_z;
    const mrpt::obs::CObservation3DRangeScan::unproject_LUT_t* m_table = nullptr;
};
}  // namespace voxeland
