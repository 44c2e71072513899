// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <sys/types.h>

namespace voxeland
{
/** A new, empty file or folder under a temporary name beside its target, to be written and moved
 * to its place. Each has a name of its own and is locked as long as the object lives; parts of
 * writers that were killed are removed by the next one of the same target: they are known by their
 * name, TARGET.xxxxxxxx.part with eight consonants, and by the lock that nobody holds. */
class OutputPart
{
 public:
    enum class Kind
    {
        file,
        folder
    };

    /** \throws OutputError if it cannot be created */
    OutputPart(const std::string& target, Kind kind);
    /** Removes it, and what is in it, unless it was moved. */
    ~OutputPart();
    OutputPart(const OutputPart&) = delete;
    OutputPart& operator=(const OutputPart&) = delete;

    /** Where to write. */
    [[nodiscard]] const std::string& path() const { return m_path; }
    /** Waits until what was written is on the disk, and gives it another name in the same folder,
     * in the place of what has it. Stays locked.
     *  \return 0, or the system's errno if that fails
     *  \throws std::bad_alloc if memory was refused: something may be missing in it */
    [[nodiscard]] int moveTo(const std::string& name);

 private:
    friend void removeUnfinishedParts();

    bool create(const std::string& path);
    bool take();
    void setPath(std::string path);
    [[nodiscard]] int sync() const;

    Kind m_kind;
    std::string m_path;  //!< empty if there is none, or it was moved
    int m_lock = -1;     //!< descriptor that the lock is held through
    pid_t m_process;     //!< that it belongs to: not to those that one starts
    OutputPart* m_next = nullptr;
};

/** Removes all parts of this process, which is about to end by a signal or at once: no other one
 * can be created or moved any more. May be called by a handler of signals. */
void removeUnfinishedParts();

/** Whether what was opened as the descriptor is what has that name now. */
[[nodiscard]] bool isNamed(int descriptor, const std::string& path);

/** Makes renamings in a file's folder outlast a loss of power, where the file system can. */
void syncFolderOf(const std::string& file);
}  // namespace voxeland
