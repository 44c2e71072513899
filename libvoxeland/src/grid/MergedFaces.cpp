// SPDX-License-Identifier: BSD-3-Clause
#include "MergedFaces.h"

#include "VoxelFaces.h"

#include <algorithm>
#include <map>
#include <utility>

namespace voxeland
{
namespace
{
/** Where a face is among those of its side: plane, row in it, column in that. */
using Place = std::array<int32_t, 3>;

/** The axes of places of a side. */
std::array<size_t, 3> axesOf(size_t side)
{
    const size_t plane = side / 2;
    return {plane, (plane + 2) % 3, (plane + 1) % 3};
}

/** Merges the faces of one side, given row by row. */
class Merging
{
 public:
    Merging(size_t side, std::vector<FaceRectangle>& rectangles)
        : m_side(side), m_rectangles(rectangles)
    {
    }

    /** Takes faces of neighbouring columns. */
    void add(const Place& first, int32_t columns)
    {
        const auto [plane, row, column] = first;
        if (plane != m_plane || row != m_row) {
            const bool isNext = plane == m_plane && row == m_row + 1;
            m_before = isNext ? std::exchange(m_current, {}) : Runs();
            m_current.clear();
            m_plane = plane;
            m_row = row;
        }
        const std::pair run(column, columns);
        const auto before = m_before.find(run);
        if (before == m_before.end()) {
            m_current[run] = m_rectangles.size();
            m_rectangles.push_back(rectangle(first, columns));
        } else {
            m_current[run] = before->second;
            ++m_rectangles[before->second].size[axesOf(m_side)[1]];
        }
    }

 private:
    using Runs = std::map<std::pair<int32_t, int32_t>, size_t>;

    [[nodiscard]] FaceRectangle rectangle(const Place& first, int32_t columns) const
    {
        const auto axes = axesOf(m_side);
        FaceRectangle result{m_side, {}, {1, 1, 1}};
        for (size_t i = 0; i < first.size(); ++i) result.low[axes[i]] = first[i];
        result.size[axes[2]] = columns;
        return result;
    }

    size_t m_side;
    std::vector<FaceRectangle>& m_rectangles;
    int32_t m_plane = 0, m_row = 0;
    Runs m_before, m_current;  //!< column and columns -> rectangle, of the last two rows
};

/** \param faces of one side; sorted here */
void merge(size_t side, std::vector<Place>& faces, std::vector<FaceRectangle>& rectangles)
{
    std::sort(faces.begin(), faces.end());
    Merging merging(side, rectangles);
    for (size_t i = 0; i < faces.size();) {
        size_t end = i + 1;
        while (end < faces.size() &&
               faces[end] ==
                   Place{faces[i][0], faces[i][1], faces[i][2] + static_cast<int32_t>(end - i)})
            ++end;
        merging.add(faces[i], static_cast<int32_t>(end - i));
        i = end;
    }
}
}  // namespace

std::vector<FaceRectangle> mergedFaces(const std::vector<VoxelCoord>& voxels,
                                       const std::function<bool(const VoxelCoord&)>& isCovered)
{
    std::vector<FaceRectangle> rectangles;
    for (size_t side = 0; side < FACES.size(); ++side) {
        std::vector<Place> faces;
        const auto [plane, row, column] = axesOf(side);
        for (const VoxelCoord& v : voxels) {
            if (isCovered(v + FACES[side])) continue;
            const Place at = {v.x, v.y, v.z};
            faces.push_back({at[plane], at[row], at[column]});
        }
        merge(side, faces, rectangles);
    }
    return rectangles;
}
}  // namespace voxeland
