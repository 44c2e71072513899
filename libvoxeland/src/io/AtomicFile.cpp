// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/AtomicFile.h"

#include "voxeland/errors.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
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
    const bool special = fs::exists(target, ignored) && !fs::is_regular_file(target, ignored);
    // A link keeps pointing where it points: what it points to is replaced.
    const fs::path real = fs::weakly_canonical(target, ignored);
    if (!special && !real.empty()) m_target = real.string();
    m_part = special ? m_target : m_target + ".part";
}

AtomicFile::~AtomicFile()
{
    if (m_begun && !m_committed && !isDirect()) unlink(m_part.c_str());
}

void AtomicFile::commit()
{
    if (!isDirect() && std::rename(m_part.c_str(), m_target.c_str()) != 0) fail(errno);
    m_committed = true;
}

void AtomicFile::checkAccess() const
{
    const std::string folder = fs::path(m_part).parent_path().string();
    const bool possible = isDirect()
                              ? access(m_target.c_str(), W_OK) == 0
                              : access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) == 0;
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
