// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <filesystem>

namespace voxeland
{
class ScanNetAnnotation;

/** ScanNet's `.sens` files, version 4, read where they are: only one frame at a time is in memory.
 *
 *  - Colour as JPEG, PNG or raw; depth as zlib stream or raw. The numbers that make a metre are in
 *    the file.
 *  - Frames are numbered from 0, and named `color/N.jpg` as when extracted.
 *  - Time is 2017-01-01 00:00:00 UTC plus the depth image's timestamp; where timestamps do not
 *    increase, plus n/30 s.
 *  - Otherwise as ScanNetFolderReader.
 *
 *  A frame whose pose is no rigid transform (-inf where tracking was lost) is skipped. */
class ScanNetSensReader : public RgbdDatasetReader
{
 public:
    /** Reads the header and where each frame is.
     *  \throws InputError, naming the file, if it is truncated or something else */
    explicit ScanNetSensReader(const std::string& file, const DatasetOptions& options = {});
    ~ScanNetSensReader() override;

    [[nodiscard]] std::string name() const override { return "ScanNet (.sens)"; }

 protected:
    [[nodiscard]] RgbdRecord read(size_t index) const override;
    [[nodiscard]] CObservationInstances::Ptr annotationOf(size_t index,
                                                          const RgbdRecord& record) const override;

 private:
    struct Content;

    std::filesystem::path m_file;
    std::unique_ptr<Content> m_content;
    std::unique_ptr<ScanNetAnnotation> m_annotation;
};

/** Opens a `.sens` file, a folder with one, or a folder of extracted images. */
std::unique_ptr<RgbdDatasetReader> openScanNet(const std::string& path,
                                               const DatasetOptions& options);
}  // namespace voxeland
