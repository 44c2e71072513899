// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <ostream>
#include <string>

namespace voxeland
{
/** A file being written under a temporary name in the folder of its target, so that nobody ever
 *  sees half of it: write to part(), then commit(). Each writer has a name of its own, and holds a
 *  lock on it while it writes; parts of writers that were killed are removed by the next one.
 * Targets that are no regular files (devices, pipes) are written directly. */
class AtomicFile
{
 public:
    /** Nothing is created yet.
     *  \throws OutputError if the target's folder does not exist or the target is a folder */
    explicit AtomicFile(const std::string& target);
    /** Removes the part that was asked for unless commit() was called. */
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /** Where to write: the file is there, and empty, once it was asked for.
     *  \throws OutputError if it cannot be created */
    [[nodiscard]] const std::string& part();
    /** \throws OutputError if this user may not write there; touches no file */
    void checkAccess() const;
    /** Puts the finished part, once it is on the disk, in the place of the target.
     *  \throws OutputError if that fails */
    void commit();
    /** An OutputError that names the target, the reason (the system's errno, if any) and what to
     *  do. */
    [[noreturn]] void fail(int error) const;

 private:
    std::string m_target, m_part;  //!< the part is empty until it was asked for
    int m_lock = -1;               //!< descriptor of the part, which the lock is held through
    bool m_direct = false, m_committed = false;
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
