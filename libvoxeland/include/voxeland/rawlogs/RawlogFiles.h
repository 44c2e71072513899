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

    /** Makes MRPT look for external images where they are: in `images`, or beside the rawlog. MRPT keeps one such path for the whole process. */
    void useImages() const;

    std::filesystem::path rawlog;   //!< NAME.rawlog or NAME.simplemap
    std::filesystem::path sidecar;  //!< NAME.instances.rawlog: predictions
    std::filesystem::path images;   //!< NAME_Images: folder of external images
};

/** Names to write a rawlog under until it is complete, beside the place where it will be. */
class StagedRawlog
{
 public:
    /** Removes what a run that died may have left there.
     *  \param file the rawlog to make or to replace, ending in .rawlog
     *  \throws OutputError if the folder for its images exists without that rawlog,
     *  ConfigurationError for another ending */
    explicit StagedRawlog(const std::string& file);
    /** Removes what was not put in place. */
    ~StagedRawlog();
    StagedRawlog(const StagedRawlog&) = delete;
    StagedRawlog& operator=(const StagedRawlog&) = delete;

    [[nodiscard]] const RawlogFiles& target() const { return m_target; }
    /** Where to write: same folder, other names. */
    [[nodiscard]] const RawlogFiles& part() const { return m_part; }
    /** For a new version of the same rawlog: images of the old one stay. */
    void keepImages() { m_keepImages = true; }

    /** Moves what was written to its place. A sidecar or images of an earlier rawlog of that name
     *  are removed: they would be taken for a part of this one. \throws OutputError */
    void putInPlace();

 private:
    void discard() const;

    RawlogFiles m_target, m_part;
    bool m_keepImages = false;
};
}  // namespace voxeland
