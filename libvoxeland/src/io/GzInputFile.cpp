// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/GzInputFile.h"

#include "voxeland/errors.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <zlib.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** \param what of MRPT's exception */
std::string reason(const std::string& what)
{
    const auto says = [&](const char* text) { return what.find(text) != std::string::npos; };
    if (says("not registered")) return "an object of a class that is not known here";
    if (says("unknown serialization version"))
        return "an object of a newer version than is known here; was it written with a newer MRPT?";
    return "the file is damaged or not of MRPT objects";
}
}  // namespace

GzInputFile::GzInputFile(const std::string& file) : m_name(file)
{
    std::error_code error;
    if (fs::is_directory(file, error))
        throw InputError(
            file + " is a folder, not a file: rgbd2rawlog makes a rawlog of a folder of images");
    m_file = gzopen(file.c_str(), "rb");
    if (!m_file) throw InputError("cannot open " + file + ": " + std::strerror(errno));
    m_fileSize = fs::file_size(file, error);
    if (error) m_fileSize = 0;
}

GzInputFile::~GzInputFile()
{
    gzclose(m_file);
}

mrpt::serialization::CSerializable::Ptr GzInputFile::readObject()
{
    m_objectBytes.clear();
    const std::string where = m_name + " after " + std::to_string(m_position) + " bytes";
    try {
        const auto object = mrpt::serialization::archiveFrom(*this).ReadObject();
        updateProgress();
        return object;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        if (m_objectBytes.empty() && gzeof(m_file)) {
            int state = Z_OK;
            gzerror(m_file, &state);
            if (state == Z_OK) return nullptr;
        }
        if (gzeof(m_file)) throw InputError(where + ": the file is cut off or damaged");
        throw InputError(where + ": " + reason(e.what()));
    }
}

/** zlib's own count may be asked for by the thread that reads alone. */
void GzInputFile::updateProgress()
{
    if (m_fileSize > 0)
        m_progress = static_cast<double>(gzoffset(m_file)) / static_cast<double>(m_fileSize);
}

size_t GzInputFile::Read(void* data, size_t bytes)
{
    constexpr size_t MOST_AT_ONCE = size_t{1} << 30;  // zlib counts in int
    auto* at = static_cast<char*>(data);
    size_t left = bytes;
    while (left > 0) {
        const auto n = static_cast<unsigned>(std::min(left, MOST_AT_ONCE));
        const int got = gzread(m_file, at, n);
        if (got < 0) throw InputError(m_name + ": the file is cut off or damaged");
        m_objectBytes.append(at, static_cast<size_t>(got));
        at += got;
        left -= static_cast<size_t>(got);
        if (static_cast<unsigned>(got) < n) break;
    }
    m_position += bytes - left;
    return bytes - left;
}

size_t GzInputFile::Write(const void*, size_t)
{
    throw std::logic_error("an input file cannot be written");
}

uint64_t GzInputFile::Seek(int64_t, TSeekOrigin)
{
    throw std::logic_error("a gzip file cannot be read out of order");
}
}  // namespace voxeland
