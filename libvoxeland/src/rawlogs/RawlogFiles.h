// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace voxeland
{
/** A rawlog, or a simplemap, and what may lie beside it. */
struct RawlogFiles
{
    explicit RawlogFiles(const std::string& file);
    /** Those of a rawlog that is to be read: where a run was killed while it replaced them, that is
     *  finished first (see StagedRawlog). \throws InputError if it cannot be finished */
    static RawlogFiles toRead(const std::string& file);

    /** Makes MRPT look for external images where they are: in `images`, or beside the rawlog. MRPT
     * keeps one such path for the whole process. */
    void useImages() const;

    std::filesystem::path rawlog;   //!< NAME.rawlog or NAME.simplemap
    std::filesystem::path sidecar;  //!< NAME.instances.rawlog: predictions
    std::filesystem::path images;   //!< NAME_Images: folder of external images
};
}  // namespace voxeland
