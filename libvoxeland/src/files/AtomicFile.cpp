// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/AtomicFile.h"

#include "OutputPart.h"
#include "voxeland/base/errors.h"
#include "writeFailure.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** Whether a name like /dev/stdout stands for what this program writes to. */
bool isStandardOutput(const std::string& file)
{
    struct stat named
    {
    }, own{};
    return stat(file.c_str(), &named) == 0 && fstat(STDOUT_FILENO, &own) == 0 &&
           named.st_dev == own.st_dev && named.st_ino == own.st_ino;
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
    if (m_direct && !fs::is_character_file(target, ignored) && !isStandardOutput(target))
        throw OutputError("cannot write " + target +
                          ": it is a pipe, socket or disk: name a file, or /dev/stdout");
    // A link keeps pointing where it points: what it points to is replaced.
    const fs::path real = fs::weakly_canonical(target, ignored);
    if (!m_direct && !real.empty()) m_target = real.string();
}

AtomicFile::~AtomicFile() = default;

const std::string& AtomicFile::part()
{
    if (m_direct) return m_target;
    if (!m_part) m_part = std::make_unique<OutputPart>(m_target, OutputPart::Kind::file);
    return m_part->path();
}

void AtomicFile::commit()
{
    if (m_direct) return;
    if (const int error = m_part->moveTo(m_target)) fail(error);
}

void AtomicFile::checkAccess() const
{
    const fs::path folder = fs::path(m_target).parent_path();
    const bool possible = m_direct
                              ? access(m_target.c_str(), W_OK) == 0
                              : access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) == 0;
    if (!possible) fail(errno);
}

void AtomicFile::fail(int error) const
{
    failToWrite(m_target, error);
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
