// SPDX-License-Identifier: BSD-3-Clause
#include "GzInputFile.h"

#include "PictureDecoders.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/InputFile.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr auto COPY_IT = ": copy it again, or make it anew";

/** \param what of MRPT's exception */
std::string reason(const std::string& what)
{
    const auto says = [&](const char* text) { return what.find(text) != std::string::npos; };
    if (says("not registered"))
        return "an object of a class that is not known here: is it a rawlog of other programs, or "
               "damaged?";
    if (says("unknown serialization version"))
        return "an object of a newer version than is known here; was it written with a newer MRPT?";
    if (says("JPEG")) return "a picture in it is damaged: copy the file again, or make it anew";
    return "the file is damaged or not of MRPT objects: copy it again, or name another";
}

/** Memory that an object of a file may take, and how many times the file's size if that is more
 *  [bytes]. */
constexpr uint64_t LARGEST_OBJECT = uint64_t{1} << 30, LARGEST_RATIO = 50;

/** Memory that this program has reserved; 0 if that cannot be told [bytes]. */
uint64_t memoryReserved()
{
    static const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    char text[100] = "";
    if (file < 0 || pread(file, text, sizeof(text) - 1, 0) <= 0) return 0;
    return std::strtoull(text, nullptr, 10) * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

/** Keeps the program from reserving more memory than this while it lives: MRPT's classes take the
 *  memory for what the sizes in a file say before they read it. */
class MemoryLimit
{
 public:
    explicit MemoryLimit(uint64_t bytes)
    {
        const uint64_t reserved = memoryReserved();
        if (reserved == 0 || getrlimit(RLIMIT_AS, &m_before) != 0) return;
        rlimit limit = m_before;
        limit.rlim_cur = std::min<rlim_t>(m_before.rlim_cur, reserved + bytes);
        m_isSet = setrlimit(RLIMIT_AS, &limit) == 0;
    }
    ~MemoryLimit()
    {
        if (m_isSet) setrlimit(RLIMIT_AS, &m_before);
    }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
    rlimit m_before{};
    bool m_isSet = false;
};
}  // namespace

GzInputFile::GzInputFile(const std::string& file) : m_name(file)
{
    std::error_code error;
    if (fs::is_directory(file, error))
        throw InputError(
            file + " is a folder, not a file: rgbd2rawlog makes a rawlog of a folder of images");
    m_fileSize = checkInputFile(file, "the file");
    m_file = gzopen(file.c_str(), "rb");
    if (!m_file) throw InputError("cannot open " + file + ": " + std::strerror(errno));
}

GzInputFile::~GzInputFile()
{
    gzclose(m_file);
}

/** \throws InputError if the file is cut off */
bool GzInputFile::isAtEnd()
{
    const int next = gzgetc(m_file);
    if (next >= 0) return gzungetc(next, m_file) < 0;
    int state = Z_OK;
    gzerror(m_file, &state);
    if (state == Z_OK) return true;
    fail();
}

void GzInputFile::fail() const
{
    int state = Z_OK;
    gzerror(m_file, &state);
    if (state == Z_MEM_ERROR) throw std::bad_alloc();
    throw InputError(m_name + ": the file is cut off or damaged" + COPY_IT);
}

mrpt::serialization::CSerializable::Ptr GzInputFile::readObject()
{
    m_objectBytes.clear();
    if (isAtEnd()) return nullptr;
    const std::string where = m_name + " after " + std::to_string(m_position) + " bytes";
    const uint64_t damagedBefore = voxeland::damagedPictures();
    const bool wasNoted = RefusedMemory::isNoted();
    try {
        const MemoryLimit limit(std::max(LARGEST_OBJECT, LARGEST_RATIO * m_fileSize));
        const auto object = mrpt::serialization::archiveFrom(*this).ReadObject();
        m_damagedPictures += voxeland::damagedPictures() - damagedBefore;
        updateProgress();
        return object;
    } catch (const std::bad_alloc&) {
        RefusedMemory::forget(wasNoted);
        throw InputError(where +
                         ": an object takes more memory than this program may use: the file is "
                         "damaged, or memory is short: copy it again, or free memory");
    } catch (const std::exception& e) {
        if (gzeof(m_file)) throw InputError(where + ": the file is cut off or damaged" + COPY_IT);
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
        if (got < 0) fail();
        m_objectBytes.append(at,
                             std::min(static_cast<size_t>(got), m_mostKept - m_objectBytes.size()));
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
