// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Colors.h"
#include "VoxelScene.h"

#include <functional>
#include <string>
#include <vector>

namespace voxeland
{
/** One way to colour a scene, with what its legend has to say. */
struct ViewColoring
{
    struct Entry
    {
        Color color;
        std::string text;
    };
    struct Label
    {
        cv::Vec3f position;  //!< in the levelled frame [m]
        std::string text;
    };

    std::string name;  //!< as in file names
    std::string title;
    std::vector<Color> colors;  //!< of VoxelScene::voxels()
    std::vector<Entry> legend;  //!< the most important first
    std::vector<Label> labels;  //!< to write into the picture, the most important first
    double barMaximum = 0;      //!< value of the colour bar's red end [nat]; 0: no bar
};

/** The five colourings of exportViews(), one after another: each has a colour for every voxel. */
void forEachColoring(const SemanticVoxelMap& map, const VoxelScene& scene,
                     const std::function<void(const ViewColoring&)>& draw);
}  // namespace voxeland
