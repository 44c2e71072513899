// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <filesystem>
#include <memory>

namespace voxeland
{
class SceneNNAnnotation;

/** SceneNN, its recordings extracted by the dataset's own playback tool: `image/imageNNNNN.png`,
 *  `depth/depthNNNNN.png`, `trajectory.log` (or `NNN_trajectory.log`).
 *
 *  - Depth is 16 bit in mm and registered to colour.
 *  - The camera is that of `asus.ini` (lines `fx 544.47329` ...) in the folder, its `intrinsic`
 *    folder or those of the folder above; without it the same camera by default.
 *  - Frames are numbered by the file names, which count from 1: the first block of the trajectory
 *    is for image 1, or for image 0 if there is one. Blocks are camera-to-world matrices.
 *  - There are no timestamps: frame n is at 2016-01-01 00:00:00 UTC + n/30 s.
 *  - The world's axes are those of the meshes.
 *  - Annotation: see SceneNNAnnotation.
 *
 *  A frame without depth or with a pose that is no rigid transform (rotation 0 where tracking was
 *  lost) is skipped. Recordings (`.oni`) cannot be read. */
class SceneNNReader : public RgbdDatasetReader
{
 public:
    /** \throws InputError if a file is missing or malformed */
    explicit SceneNNReader(const std::string& folder, const DatasetOptions& options = {});
    ~SceneNNReader() override;

    [[nodiscard]] std::string name() const override { return "SceneNN"; }

 protected:
    [[nodiscard]] RgbdRecord read(size_t index) const override;
    [[nodiscard]] CObservationInstances::Ptr annotationOf(size_t index,
                                                          const RgbdRecord& record) const override;

 private:
    PinholeCamera findCamera();
    void readTrajectory();

    std::filesystem::path m_folder;
    std::vector<std::vector<double>> m_poses;  //!< 16 numbers each
    int64_t m_firstImage = 1;
    std::unique_ptr<SceneNNAnnotation> m_annotation;
};
}  // namespace voxeland
