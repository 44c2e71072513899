// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "RawlogFiles.h"
#include "files/OutputPart.h"

namespace voxeland
{
/** A rawlog being written, with its sidecar and images, in a temporary folder beside the place
 * where it will be. A run that dies at any moment leaves the old one or the new one, never parts of
 * both: all of the new one lies ready when the folder is renamed to NAME.rawlog.replacing, and from
 * then on whoever opens the rawlog finishes moving it to its place. (Programs that do not know of
 * that folder see files of both for as long as nobody has.) */
class StagedRawlog
{
 public:
    /** Removes what a run that died may have left there.
     *  \param file the rawlog to make or to replace, ending in .rawlog; if it is a link, what it
     *  points to is replaced, and sidecar and images are beside the link, where readers look
     *  \throws OutputError if it cannot be written, or if the folder for its images exists without
     * that rawlog, ConfigurationError for another ending */
    explicit StagedRawlog(const std::string& file);
    StagedRawlog(const StagedRawlog&) = delete;
    StagedRawlog& operator=(const StagedRawlog&) = delete;

    [[nodiscard]] const RawlogFiles& target() const { return m_target; }
    /** Where to write: the same names, in another folder. */
    [[nodiscard]] const RawlogFiles& part() const { return m_part; }
    /** For a new version of the same rawlog: images of the old one stay. */
    void keepImages() { m_keepImages = true; }

    /** Moves what was written to its place. A sidecar or images of an earlier rawlog of that name
     *  are removed: they would be taken for a part of this one. A rawlog stays if no new one was
     *  written. \throws OutputError */
    void putInPlace();

 private:
    RawlogFiles m_target;
    OutputPart m_folder;
    RawlogFiles m_part;
    bool m_keepImages = false;
};

/** Finishes what a run that was killed had begun: the move of a complete new rawlog to its place.
 * Waits for a run that is at it. \throws OutputError if it cannot be finished */
void finishReplacing(const RawlogFiles& target);
}  // namespace voxeland
