// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <filesystem>

namespace voxeland
{
/** Microsoft's 7-Scenes: `seq-NN/frame-NNNNNN` with `.color.png`, `.depth.png` and `.pose.txt`.
 *
 *  - The folder may be a scene (all its sequences are read, in order) or one sequence.
 *  - Colour may also be `.color.jpg`. Depth is 16 bit in mm; 0 and 65535 are invalid (65535 becomes
 *    0). Depth is taken as registered to colour, as the dataset recommends.
 *  - `camera-intrinsics.txt` (3x3 matrix) in the sequence's folder or the one above holds for both
 *    images; without it the dataset's default: focal length 585, centre (320, 240) pixels.
 *  - Poses become those of a robot whose sensor sits at its origin.
 *  - Frame numbers are those of the file names; a further sequence goes on behind the last one.
 *  - The dataset has no timestamps: frame n is at 2013-01-01 00:00:00 UTC + n/30 s.
 *
 *  A frame with a missing file or with a pose that is no rigid transform is skipped; an image that
 *  cannot be decoded is an error. */
class SevenScenesReader : public RgbdDatasetReader
{
 public:
    /** \throws InputError if there are no such files, or the intrinsics make no sense */
    explicit SevenScenesReader(const std::string& folder, const DatasetOptions& options = {});

    [[nodiscard]] std::string name() const override { return "7-Scenes"; }

 protected:
    [[nodiscard]] RgbdRecord read(size_t index) const override;

 private:
    std::vector<std::filesystem::path> m_stems;  //!< ".../frame-000012", one for each frame
};
}  // namespace voxeland
