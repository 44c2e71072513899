// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <filesystem>
#include <memory>

namespace voxeland
{
class ScanNetAnnotation;

/** ScanNet, extracted: `color/N.jpg` (or .png), `depth/N.png`, `pose/N.txt`,
 *  `intrinsic/intrinsic_{color,depth}.txt`.
 *
 *  - Depth is 16 bit in mm. Colour and depth have a size and a camera each; both are taken to be at
 *    the same place. Masks belong to the colour images.
 *  - Frames are numbered by the file names of colour images.
 *  - There are no timestamps: frame n is at 2017-01-01 00:00:00 UTC + n/30 s.
 *  - The poses' frame of reference, which is also that of the meshes, is kept: `axisAlignment` is
 *    not applied.
 *  - Annotation: see ScanNetAnnotation.
 *
 *  A frame without depth or pose, or with a pose that is no rigid transform (-inf where tracking
 * was lost), is skipped. */
class ScanNetFolderReader : public RgbdDatasetReader
{
 public:
    /** \throws InputError if there are no such files */
    explicit ScanNetFolderReader(const std::string& folder, const DatasetOptions& options = {});
    ~ScanNetFolderReader() override;

    [[nodiscard]] std::string name() const override { return "ScanNet"; }

 protected:
    [[nodiscard]] RgbdRecord read(size_t index) const override;
    [[nodiscard]] CObservationInstances::Ptr annotationOf(size_t index,
                                                          const RgbdRecord& record) const override;

 private:
    std::filesystem::path m_folder;
    std::unique_ptr<ScanNetAnnotation> m_annotation;
};
}  // namespace voxeland
