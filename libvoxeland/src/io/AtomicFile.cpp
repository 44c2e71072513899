// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/AtomicFile.h"

#include "voxeland/errors.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <locale>
#include <random>
#include <sys/file.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** What the user can do about it. */
const char* remedy(int error)
{
    switch (error) {
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "free some space or choose another place";
        case EACCES:
        case EPERM:
        case EROFS:
            return "choose a place you may write to";
        default:
            return "check the path and the disk";
    }
}

constexpr size_t RANDOM_CHARACTERS = 8;
constexpr auto EXTENSION = ".part";

std::string folderOf(const std::string& file)
{
    const std::string folder = fs::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

/** A name of its own for each writer, beside the target. */
std::string newPartOf(const std::string& target)
{
    constexpr char LETTERS[] = "abcdefghijklmnopqrstuvwxyz";
    std::random_device random;
    std::uniform_int_distribution<size_t> any(0, sizeof(LETTERS) - 2);
    std::string name = target + ".";
    for (size_t i = 0; i < RANDOM_CHARACTERS; ++i) name += LETTERS[any(random)];
    return name + EXTENSION;
}

/** Whether a file is named as newPartOf() names those of a target. */
bool isPartOf(const std::string& name, const std::string& target)
{
    const size_t length = target.size() + 1 + RANDOM_CHARACTERS + std::strlen(EXTENSION);
    return name.size() == length && name.compare(0, target.size() + 1, target + ".") == 0 &&
           fs::path(name).extension() == EXTENSION;
}

/** Removes what writers that were killed have left: parts that nobody holds the lock of. */
void removeAbandonedParts(const std::string& target)
{
    const std::string name = fs::path(target).filename().string();
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folderOf(target), ignored)) {
        if (!isPartOf(entry.path().filename().string(), name)) continue;
        const int file = open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
        if (file < 0) continue;
        if (flock(file, LOCK_EX | LOCK_NB) == 0) unlink(entry.path().c_str());
        close(file);
    }
}

/** Makes a renaming in a file's folder outlast a loss of power, where the file system can. */
void syncFolderOf(const std::string& file)
{
    const int folder = open(folderOf(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    fsync(folder);
    close(folder);
}
}  // namespace

AtomicFile::AtomicFile(const std::string& target) : m_target(target)
{
    std::error_code ignored;
    if (target.empty()) throw OutputError("no name given for an output file: give one");
    if (fs::is_directory(target, ignored))
        throw OutputError("cannot write " + target + ": it is a folder: name a file in it");
    const fs::path folder = fs::path(target).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw OutputError("cannot write " + target + ": there is no folder " + folder.string() +
                          ": create it first");
    m_direct = fs::exists(target, ignored) && !fs::is_regular_file(target, ignored);
    // A link keeps pointing where it points: what it points to is replaced.
    const fs::path real = fs::weakly_canonical(target, ignored);
    if (!m_direct && !real.empty()) m_target = real.string();
}

AtomicFile::~AtomicFile()
{
    if (!m_part.empty() && !m_direct && !m_committed) unlink(m_part.c_str());
    if (m_lock >= 0) close(m_lock);
}

const std::string& AtomicFile::part()
{
    if (!m_part.empty()) return m_part;
    if (m_direct) return m_part = m_target;
    removeAbandonedParts(m_target);
    do {
        m_part = newPartOf(m_target);
        m_lock = open(m_part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (m_lock < 0 && errno == EEXIST);
    if (m_lock < 0) {
        m_part.clear();
        fail(errno);
    }
    flock(m_lock, LOCK_EX | LOCK_NB);
    return m_part;
}

void AtomicFile::commit()
{
    if (!m_direct) {
        if (fsync(m_lock) != 0 || std::rename(m_part.c_str(), m_target.c_str()) != 0) fail(errno);
        syncFolderOf(m_target);
    }
    m_committed = true;
}

void AtomicFile::checkAccess() const
{
    const std::string folder = folderOf(m_target);
    const bool possible =
        m_direct ? access(m_target.c_str(), W_OK) == 0 : access(folder.c_str(), W_OK | X_OK) == 0;
    if (!possible) fail(errno);
}

void AtomicFile::fail(int error) const
{
    throw OutputError("cannot write " + m_target + ": " +
                      (error == 0 ? "unknown reason" : std::strerror(error)) + ": " +
                      remedy(error));
}

void checkWritable(const std::string& file)
{
    AtomicFile(file).checkAccess();
}

void writeAtomically(const std::string& file, const std::function<void(std::ostream&)>& write)
{
    AtomicFile target(file);
    errno = 0;
    std::ofstream out(target.part(), std::ios::binary | std::ios::trunc);
    if (!out) target.fail(errno);
    out.imbue(std::locale::classic());  // numbers in files look alike everywhere
    try {
        out.exceptions(std::ios::badbit | std::ios::failbit);
        write(out);
        out.close();
    } catch (const std::ios_base::failure&) {
        target.fail(errno);
    }
    target.commit();
}

void writeAtomically(const std::string& file, const std::string& content)
{
    writeAtomically(file, [&](std::ostream& out) { out << content; });
}
}  // namespace voxeland
