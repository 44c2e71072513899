// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/UnfinishedPredictions.h"

#include "voxeland/errors.h"

#include <mrpt/serialization/CSerializable.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** Begins every file, with the version of its format. A record follows it for the origin, and one
 *  for each frame: its size in bytes [4 bytes, as this machine writes them] and so many bytes,
 * which are an MRPT object, or none where the network had nothing to look at. */
constexpr char TITLE[] = "voxeland unfinished predictions 1\n";

using Bytes = std::vector<uint8_t>;

/** \return false at the end of the file, or where it was cut off */
bool readRecord(std::istream& in, uint64_t fileSize, Bytes& bytes)
{
    uint32_t size = 0;
    if (!in.read(reinterpret_cast<char*>(&size), sizeof(size))) return false;
    if (static_cast<uint64_t>(in.tellg()) + size > fileSize) return false;
    bytes.resize(size);
    return size == 0 || in.read(reinterpret_cast<char*>(bytes.data()), size);
}

void writeRecord(std::ostream& out, const void* bytes, size_t size)
{
    const auto n = static_cast<uint32_t>(size);
    out.write(reinterpret_cast<const char*>(&n), sizeof(n));
    out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
}

/** Reads as far as the origin. \return whether it is that one */
bool isOf(std::istream& in, uint64_t fileSize, const std::string& origin)
{
    std::string title(sizeof(TITLE) - 1, '\0');
    Bytes found;
    return in.read(title.data(), static_cast<std::streamsize>(title.size())) && title == TITLE &&
           readRecord(in, fileSize, found) && std::string(found.begin(), found.end()) == origin;
}
/** Makes sure that a file is, or may be made, one of ours: what a link leads to would be lost.
 *  \throws OutputError if not */
void checkOwn(const std::string& file)
{
    const int opened =
        open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    const int error = errno;
    struct stat status
    {
    };
    const bool isFile = opened >= 0 && fstat(opened, &status) == 0 && S_ISREG(status.st_mode);
    if (opened >= 0) close(opened);
    if (isFile) return;
    const bool isOther = opened >= 0 || error == ELOOP || error == EISDIR || error == ENXIO;
    throw OutputError(
        "cannot write " + file + ": " +
        (isOther ? "it is a link, a folder or a device: remove it" : std::strerror(error)));
}
}  // namespace

UnfinishedPredictions::UnfinishedPredictions(std::string file, const std::string& origin)
    : m_file(std::move(file))
{
    checkOwn(m_file);
    m_kept.open(m_file, std::ios::binary);
    std::error_code error;
    const uint64_t size = fs::file_size(m_file, error);
    if (m_kept && !error && isOf(m_kept, size, origin)) {
        const auto first = m_kept.tellg();
        auto end = first;
        for (Bytes bytes; readRecord(m_kept, size, bytes); end = m_kept.tellg()) ++m_frames;
        m_kept.clear();
        m_kept.seekg(first);
        fs::resize_file(m_file, static_cast<uint64_t>(end), error);
        m_new.open(m_file, std::ios::binary | std::ios::app);
    } else {
        m_new.open(m_file, std::ios::binary | std::ios::trunc);
        m_new << TITLE;
        writeRecord(m_new, origin.data(), origin.size());
    }
    if (!m_new.flush() || (error && m_frames > 0))
        throw OutputError("cannot write " + m_file + ": " + std::strerror(errno));
}

CObservationInstances::Ptr UnfinishedPredictions::of(size_t frame,
                                                     const mrpt::obs::CObservation3DRangeScan& scan,
                                                     const PredictionSource& source)
{
    if (frame < m_frames) return nextKept();
    const auto predictions = source(frame, scan);
    keep(predictions.get());
    return predictions;
}

CObservationInstances::Ptr UnfinishedPredictions::nextKept()
{
    Bytes bytes;
    mrpt::serialization::CSerializable::Ptr object;
    if (readRecord(m_kept, UINT64_MAX, bytes) && !bytes.empty())
        mrpt::serialization::OctetVectorToObject(bytes, object);
    const auto predictions = std::dynamic_pointer_cast<CObservationInstances>(object);
    if (!predictions && !bytes.empty())
        throw InputError(m_file + " is damaged: remove it, and what it holds is made again");
    return predictions;
}

void UnfinishedPredictions::keep(const CObservationInstances* predictions)
{
    Bytes bytes;
    if (predictions != nullptr) mrpt::serialization::ObjectToOctetVector(predictions, bytes);
    writeRecord(m_new, bytes.data(), bytes.size());
    if (!m_new.flush())  // a killed program has written all that it was told to keep
        throw OutputError("cannot write " + m_file + ": " + std::strerror(errno));
}

void UnfinishedPredictions::discard()
{
    m_new.close();
    std::error_code ignored;
    fs::remove(m_file, ignored);
}
}  // namespace voxeland
