// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/AtomicFile.h"

#include "OutputPart.h"
#include "OutputPlace.h"
#include "writeFailure.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <locale>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland
{
AtomicFile::AtomicFile(const std::string& target)
{
    const OutputPlace place = outputPlaceOf(target);
    m_target = place.path;
    m_direct = place.isDirect;
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
    const bool possible = m_direct
                              ? access(m_target.c_str(), W_OK) == 0
                              : access(fs::path(m_target).parent_path().c_str(), W_OK | X_OK) == 0;
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
