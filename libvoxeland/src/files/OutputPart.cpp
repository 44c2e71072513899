// SPDX-License-Identifier: BSD-3-Clause
#include "OutputPart.h"

#include "FolderNames.h"
#include "removeTree.h"
#include "voxeland/base/RefusedMemory.h"
#include "writeFailure.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr size_t RANDOM_CHARACTERS = 8;
constexpr std::string_view LETTERS =
    "bcdfghjkmnpqrstvwxz";  // words, of people's own files, have vowels
constexpr auto EXTENSION = ".part";

std::string folderOf(const std::string& file)
{
    const std::string folder = fs::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

/** A name of its own for each writer, beside the target. */
std::string newPartOf(const std::string& target)
{
    std::random_device random;
    std::uniform_int_distribution<size_t> any(0, LETTERS.size() - 1);
    std::string name = target + ".";
    for (size_t i = 0; i < RANDOM_CHARACTERS; ++i) name += LETTERS[any(random)];
    return name + EXTENSION;
}

/** Whether a file is named as newPartOf() names those of a target. */
bool isPartOf(const std::string& name, const std::string& target)
{
    const size_t begin = target.size() + 1, end = begin + RANDOM_CHARACTERS;
    return name.size() > end && name.compare(0, begin, target + ".") == 0 &&
           name.find_first_not_of(LETTERS, begin) == end &&
           name.compare(end, std::string::npos, EXTENSION) == 0;
}

/** Removes a part, file or folder. */
void remove(const std::string& part)
{
    removeTree(AT_FDCWD, part.c_str());
}

std::atomic_flag namesAreTaken = ATOMIC_FLAG_INIT;
OutputPart* firstPart = nullptr;  //!< list of all

/** Keeps other threads from the names of parts, and handlers of signals from this thread. */
void takeNames(sigset_t& before)
{
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    while (namesAreTaken.test_and_set(std::memory_order_acquire)) continue;
}

/** Held while names of parts change: a handler of signals reads them, in this thread or another. */
class NamesLock
{
 public:
    NamesLock() { takeNames(m_before); }
    ~NamesLock()
    {
        namesAreTaken.clear(std::memory_order_release);
        pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }
    NamesLock(const NamesLock&) = delete;
    NamesLock& operator=(const NamesLock&) = delete;

 private:
    sigset_t m_before{};
};

/** Removes what writers that were killed have left: parts that nobody holds the lock of. */
void removeAbandonedParts(const std::string& target)
{
    const std::string name = fs::path(target).filename().string();
    const std::string folder = folderOf(target);
    for (const std::string& found : namesIn(folder)) {
        if (!isPartOf(found, name)) continue;
        const std::string path = folder + "/" + found;
        const int part = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (part < 0) continue;
        if (flock(part, LOCK_EX | LOCK_NB) == 0) remove(path);
        close(part);
    }
}
}  // namespace

OutputPart::OutputPart(const std::string& target, Kind kind) : m_kind(kind), m_process(getpid())
{
    removeAbandonedParts(target);
    constexpr int MOST_ATTEMPTS = 100;
    for (int i = 0; i < MOST_ATTEMPTS; ++i) {
        if (create(newPartOf(target))) return;
        if (errno != EEXIST) break;
    }
    failToWrite(target, errno);
}

OutputPart::~OutputPart()
{
    if (!m_path.empty()) remove(m_path);
    setPath({});
    close(m_lock);
}

/** Under a name, it is in the list of all. */
void OutputPart::setPath(std::string path)
{
    const NamesLock lock;
    const bool wasNamed = !m_path.empty();
    m_path.swap(path);
    if (!wasNamed && !m_path.empty()) {
        m_next = firstPart;
        firstPart = this;
    }
    if (!wasNamed || !m_path.empty()) return;
    OutputPart** place = &firstPart;
    while (*place != this) place = &(*place)->m_next;
    *place = m_next;
}

/** \return false, with errno, if that is not possible: EEXIST if it may be under another name */
bool OutputPart::create(const std::string& path)
{
    setPath(path);  // first: a signal may come at any moment
    if (take()) return true;
    const int error = errno;
    setPath({});
    errno = error;
    return false;
}

/** Creates what has the name now, and locks it. \return false, with errno, as create() */
bool OutputPart::take()
{
    const char* const path = m_path.c_str();
    if (m_kind == Kind::folder && mkdir(path, 0777) != 0) return false;
    const int flags = m_kind == Kind::folder ? O_RDONLY | O_DIRECTORY : O_RDWR | O_CREAT | O_EXCL;
    m_lock = open(path, flags | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (m_lock < 0) {
        const int error = errno;
        if (m_kind == Kind::folder) rmdir(path);
        errno = error;
        return false;
    }
    const int refused = flock(m_lock, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (refused == 0 && isNamed(m_lock, m_path)) return true;
    // Another writer took it for abandoned before it was locked, and removes it.
    const bool isTaken = refused == 0 || refused == EWOULDBLOCK;
    if (!isTaken) remove(m_path);
    close(m_lock);
    errno = isTaken ? EEXIST : refused;
    return false;
}

int OutputPart::sync() const
{
    return (m_kind == Kind::folder ? syncfs(m_lock) : fsync(m_lock)) == 0 ? 0 : errno;
}

int OutputPart::moveTo(const std::string& name)
{
    RefusedMemory::check();
    if (const int error = sync()) return error;
    if (std::rename(m_path.c_str(), name.c_str()) != 0) return errno;
    setPath({});
    syncFolderOf(name);
    return 0;
}

void removeUnfinishedParts()
{
    sigset_t before;
    takeNames(before);  // for good
    for (const OutputPart* part = firstPart; part != nullptr; part = part->m_next)
        if (part->m_process == getpid()) remove(part->m_path);
}

bool isNamed(int descriptor, const std::string& path)
{
    struct stat opened, named;
    return fstat(descriptor, &opened) == 0 && lstat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void syncFolderOf(const std::string& file)
{
    const int folder = open(folderOf(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    fsync(folder);
    close(folder);
}
}  // namespace voxeland
