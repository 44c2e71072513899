// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/DatasetCameras.h"
#include "voxeland/observations/PoseAxes.h"

#include <optional>

namespace voxeland
{
/** What the user knows better than the dataset, or wants of it. */
struct DatasetOptions
{
    /** Camera of the depth images, and of the colour images where those are registered to it. */
    std::optional<PinholeCamera> camera;
    /** Camera of the colour images; those of a dataset that registers them then are not. */
    std::optional<PinholeCamera> colourCamera{};
    /** Numbers in a depth image that make a metre. */
    std::optional<double> depthScale;
    /** The dataset's poses are world-to-camera transforms. */
    bool invertPoses = false;
    /** Axes of those poses, after inversion if any. body: the camera's, as MRPT has them. */
    PoseAxes poseAxes = PoseAxes::optical;
    /** The dataset's own annotation serves as predictions, see RgbdRecord::instances: objects with
     *  their true category, a score of 1 and their ids as tracks. */
    bool annotation = false;
    /** Frames that cannot be used, and odd lines of lists and trajectories, are errors. */
    bool strict = false;
    /** Lists may name images outside of the dataset's folder, see namedFile(). */
    bool trustPaths = false;
};
}  // namespace voxeland
