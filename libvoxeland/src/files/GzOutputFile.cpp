// SPDX-License-Identifier: BSD-3-Clause
#include "GzOutputFile.h"

#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"
#include "writeFailure.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cerrno>
#include <zlib.h>

namespace voxeland
{
GzOutputFile::GzOutputFile(const std::string& file, int compressionLevel, const std::string& told)
    : m_name(told.empty() ? file : told),
      m_file(gzopen(file.c_str(), ("wb" + std::to_string(compressionLevel)).c_str()))
{
    if (!m_file) failToWrite(m_name, errno);
}

GzOutputFile::~GzOutputFile()
{
    if (m_file) gzclose(m_file);
}

size_t GzOutputFile::Write(const void* data, size_t bytes)
{
    constexpr size_t MOST_AT_ONCE = size_t{1} << 30;  // zlib counts in int
    const auto* at = static_cast<const char*>(data);
    for (size_t left = bytes; left > 0;) {
        const auto n = static_cast<unsigned>(std::min(left, MOST_AT_ONCE));
        errno = 0;
        if (gzwrite(m_file, at, n) != static_cast<int>(n)) fail();
        at += n;
        left -= n;
    }
    m_position += bytes;
    return bytes;
}

void GzOutputFile::writeObject(const mrpt::serialization::CSerializable& object)
{
    try {
        mrpt::serialization::archiveFrom(*this) << object;
    } catch (const std::exception&) {
        if (!m_failure.empty()) throw OutputError(m_failure);
        throw;
    }
}

void GzOutputFile::close()
{
    if (!m_file) return;
    errno = 0;
    const int result = gzclose(m_file);
    m_file = nullptr;
    if (result != Z_OK) fail();
}

void GzOutputFile::fail()
{
    try {
        failToWrite(m_name, errno);
    } catch (const OutputError& e) {
        m_failure = e.what();
        throw;
    }
}

size_t GzOutputFile::Read(void*, size_t)
{
    throw std::logic_error("an output file cannot be read");
}

uint64_t GzOutputFile::Seek(int64_t, TSeekOrigin)
{
    throw std::logic_error("a gzip file cannot be written out of order");
}

void writeAtomically(const std::string& file, const mrpt::serialization::CSerializable& object)
{
    AtomicFile target(file);
    GzOutputFile out(target.part(), GzOutputFile::FASTEST, target.target());
    out.writeObject(object);
    out.close();
    target.commit();
}
}  // namespace voxeland
