// SPDX-License-Identifier: BSD-3-Clause
#include "StagedRawlog.h"

#include "files/OutputPlace.h"
#include "files/writeFailure.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr auto EXTENSION = ".rawlog";

bool isThere(const fs::path& path)
{
    return fs::exists(fs::symlink_status(path));
}

/** Where a complete new rawlog waits for being moved to its place. */
fs::path waitingFolderOf(const RawlogFiles& target)
{
    return target.rawlog.string() + ".replacing";
}

RawlogFiles inFolder(const RawlogFiles& target, const fs::path& folder)
{
    return RawlogFiles((folder / target.rawlog.filename()).string());
}

/** The name, among the new files, that says of an old one that it is to be removed. */
fs::path removalOf(const fs::path& file)
{
    return file.string() + ".removed";
}

/** The name that an old folder gets to make place for the new one. */
fs::path oldOf(const fs::path& folder)
{
    return folder.string() + ".old";
}

/** Puts a new file or folder, or none, in the place of the old one. May be interrupted anywhere and
 * done again. */
void replace(const fs::path& target, const fs::path& waiting)
{
    const bool hasNew = isThere(waiting);
    if (!hasNew && !isThere(removalOf(waiting))) return;
    const bool inTheWay = !hasNew || fs::is_directory(fs::symlink_status(target)) ||
                          fs::is_directory(fs::symlink_status(waiting));
    if (inTheWay && isThere(target)) {
        fs::remove_all(oldOf(waiting));
        fs::rename(target, oldOf(waiting));
    }
    if (hasNew) fs::rename(waiting, target);
}

/** Moves a new file to its place, which a link may name, on another disk as well. May be
 * interrupted anywhere and done again. */
void moveFile(const fs::path& waiting, const fs::path& target)
{
    if (!isThere(waiting)) return;
    const std::string place = outputPlaceOf(target.string()).path;
    std::error_code error;
    fs::rename(waiting, place, error);
    if (error == std::errc::cross_device_link) {
        AtomicFile copy(place);
        fs::copy_file(waiting, copy.part(), fs::copy_options::overwrite_existing);
        copy.commit();
    } else if (error) {
        throw fs::filesystem_error("", waiting, place, error);
    }
    syncFolderOf(place);
}

/** \param waiting folder of the new one, whose lock is held */
void moveToPlace(const RawlogFiles& target, const fs::path& waiting)
{
    const RawlogFiles ready = inFolder(target, waiting);
    try {
        replace(target.images, ready.images);
        replace(target.sidecar, ready.sidecar);
        moveFile(ready.rawlog, target.rawlog);
        syncFolderOf(target.rawlog.string());
        fs::remove_all(waiting);
    } catch (const fs::filesystem_error& e) {
        throw OutputError("cannot replace " + target.rawlog.string() + ": " + e.code().message() +
                          ": the new one is complete in " + waiting.string() +
                          ": make the folder writable and use it again");
    }
}

/** A new rawlog that waits, held so that nobody else moves it; none if there is none. */
class HeldFolder
{
 public:
    /** \throws OutputError if there is one that cannot be held */
    HeldFolder(const fs::path& folder, const RawlogFiles& target)
        : m_descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW))
    {
        if (m_descriptor < 0 && (errno == ENOENT || errno == ENOTDIR || errno == ELOOP)) return;
        if (m_descriptor < 0) failToWrite(target.rawlog.string(), errno);
        while (flock(m_descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
        m_isThere = isNamed(m_descriptor, folder.string());
    }
    ~HeldFolder()
    {
        if (m_descriptor >= 0) close(m_descriptor);
    }
    HeldFolder(const HeldFolder&) = delete;
    HeldFolder& operator=(const HeldFolder&) = delete;

    /** False also if another run has finished it in the meantime. */
    [[nodiscard]] bool isThere() const { return m_isThere; }

 private:
    int m_descriptor;
    bool m_isThere = false;
};

/** \return the same \throws unless a rawlog may be written there */
const RawlogFiles& checked(const RawlogFiles& target)
{
    const std::string file = target.rawlog.string();
    if (target.rawlog.extension() != EXTENSION)
        throw ConfigurationError("the name of the rawlog " + file + " must end in " + EXTENSION);
    if (outputPlaceOf(file).isDirect)
        throw OutputError("cannot write " + file +
                          ": it is a device, but others lie beside a rawlog: name a file");
    checkWritable(file);
    finishReplacing(target);
    if (!fs::exists(target.rawlog) && fs::exists(target.images))
        throw OutputError("the folder " + target.images.string() +
                          " is in the way of the images of " + file +
                          ": remove it or choose another name");
    return target;
}

/** Has a file or folder removed unless a new one is there. */
void removeUnlessNew(const fs::path& target, const fs::path& part)
{
    if (!isThere(target) || isThere(part)) return;
    errno = 0;
    if (!std::ofstream(removalOf(part))) failToWrite(target.string(), errno);
}
}  // namespace

void finishReplacing(const RawlogFiles& target)
{
    const fs::path waiting = waitingFolderOf(target);
    const HeldFolder held(waiting, target);
    if (held.isThere()) moveToPlace(target, waiting);
}

StagedRawlog::StagedRawlog(const std::string& file)
    : m_target(file),
      m_folder(checked(m_target).rawlog.string(), OutputPart::Kind::folder),
      m_part(inFolder(m_target, m_folder.path()))
{
}

void StagedRawlog::putInPlace()
{
    removeUnlessNew(m_target.sidecar, m_part.sidecar);
    if (!m_keepImages) removeUnlessNew(m_target.images, m_part.images);
    const fs::path waiting = waitingFolderOf(m_target);
    int error = 0;
    do {
        finishReplacing(m_target);
        error = m_folder.moveTo(waiting.string());
    } while (error == ENOTEMPTY || error == EEXIST);
    if (error != 0) failToWrite(m_target.rawlog.string(), error);
    moveToPlace(m_target, waiting);
}
}  // namespace voxeland
