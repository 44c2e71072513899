// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <filesystem>

namespace voxeland
{
/** Replica as NICE-SLAM rendered it: `results/frameNNNNNN.jpg`, `results/depthNNNNNN.png`,
 *  `traj.txt` (a line of 16 numbers for each frame: a camera-to-world matrix).
 *
 *  - Camera and depth scale are those of `cam_params.json` in the folder or the one above; without
 *    it those that all scenes share: 1200x680 pixels, focal length 600, 6553.5 to a metre.
 *  - Depth is registered to colour.
 *  - Frames are numbered by the file names; line n of `traj.txt`, from 0, is for frame n.
 *  - There are no timestamps: frame n is at 2019-01-01 00:00:00 UTC + n/30 s.
 *
 *  A frame without depth or with a pose that is no rigid transform is skipped. */
class ReplicaReader : public RgbdDatasetReader
{
 public:
    /** \throws InputError if a file is missing or malformed */
    explicit ReplicaReader(const std::string& folder, const DatasetOptions& options = {});

    [[nodiscard]] std::string name() const override { return "Replica"; }

 protected:
    [[nodiscard]] RgbdRecord read(size_t index) const override;

 private:
    DatasetCameras findCameras();

    std::filesystem::path m_folder;
    std::vector<std::vector<double>> m_poses;  //!< numbers of each line
};
}  // namespace voxeland
