// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <ostream>
#include <string>

namespace voxeland
{
class OutputPart;

/** A file being written under a temporary name in the folder of its target (see
 *  OutputPart), so that nobody ever sees half of it: write to part(), then commit().
 * Character devices, such as /dev/null, and /dev/stdout are written directly. */
class AtomicFile
{
 public:
    /** Nothing is created yet.
     *  \param target if it is a link, what it points to is written, even if that is not there yet
     *  \throws OutputError if the target's folder does not exist, or the target is a folder, a pipe
     *  that nobody may read, a socket or a disk */
    explicit AtomicFile(const std::string& target);
    /** Removes the part that was asked for unless commit() was called. */
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /** What will be written, links followed. */
    [[nodiscard]] const std::string& target() const { return m_target; }
    /** Where to write: the file is there, and empty, once it was asked for.
     *  \throws OutputError if it cannot be created */
    [[nodiscard]] const std::string& part();
    /** \throws OutputError if this user may not write there; touches no file */
    void checkAccess() const;
    /** Puts the finished part, once it is on the disk, in the place of the target.
     *  \throws OutputError if that fails */
    void commit();
    /** As failToWrite(), of the target. */
    [[noreturn]] void fail(int error) const;

 private:
    std::string m_target;
    std::unique_ptr<OutputPart> m_part;  //!< null until it was asked for
    bool m_direct = false;
};

/** Makes sure before long work that a file may be written after it: that its folder, or the device
 * or pipe, lets this user write. Touches no file. A full disk shows only when it is written.
 *  \throws OutputError if it cannot, or no name is given */
void checkWritable(const std::string& file);

/** Writes a whole file through AtomicFile.
 *  \param write puts the content into the stream; binary, and may throw
 *  \throws OutputError, naming the file, if not all of it could be written */
void writeAtomically(const std::string& file, const std::function<void(std::ostream&)>& write);
/** The same of a content at hand, text or bytes. */
void writeAtomically(const std::string& file, const std::string& content);
}  // namespace voxeland
