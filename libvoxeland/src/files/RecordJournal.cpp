// SPDX-License-Identifier: BSD-3-Clause
#include "RecordJournal.h"

#include "OutputPart.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/errors.h"
#include "writeFailure.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <zlib.h>

namespace voxeland
{
namespace
{
/** Comes before each record, as this machine writes numbers. The first record is the origin. */
struct RecordHeader
{
    uint32_t size = 0, checksum = 0;
};

uint32_t checksumOf(const RecordJournal::Bytes& bytes)
{
    return static_cast<uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}
}  // namespace

RecordJournal::RecordJournal(std::string file)
    : m_file(std::move(file)),
      m_descriptor(open(m_file.c_str(),
                        O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666))
{
    if (m_descriptor < 0 && errno != ELOOP && errno != EISDIR && errno != ENXIO)
        failToWrite(m_file, errno);
}

RecordJournal::RecordJournal(std::string file, const std::string& title, const std::string& origin)
    : RecordJournal(std::move(file))
{
    struct stat status
    {
    };
    const bool isFile =
        m_descriptor >= 0 && fstat(m_descriptor, &status) == 0 && S_ISREG(status.st_mode);
    if (!isFile)
        throw OutputError("cannot write " + m_file +
                          ": it is a link, a folder or a device: remove it");
    // Who held it until now may have added to it, or removed it.
    if (flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 || fstat(m_descriptor, &status) != 0 ||
        status.st_nlink == 0)
        throw OutputError("cannot write " + m_file +
                          ": another run with the same output is at it: wait for its end");
    m_size = static_cast<uint64_t>(status.st_size);
    m_in.open("/proc/self/fd/" + std::to_string(m_descriptor), std::ios::binary);
    const bool isAnEarlierOne = isOf(title, origin);
    checkRead();
    if (isAnEarlierOne) {
        const auto first = m_in.tellg();
        auto end = first;
        for (; readRecord(); end = m_in.tellg()) ++m_kept;
        checkRead();
        m_in.clear();
        m_in.seekg(first);
        if (ftruncate(m_descriptor, end) != 0) failToWrite(m_file, errno);
    } else {
        begin(title, origin);
    }
}

RecordJournal::~RecordJournal()
{
    if (m_descriptor >= 0) close(m_descriptor);
}

/** Before anything is cut off. \throws InputError if it is only that it cannot be read */
void RecordJournal::checkRead() const
{
    RefusedMemory::check();
    if (!m_in.is_open() || m_in.bad())
        throw InputError("cannot read " + m_file + ": check the disk");
}

bool RecordJournal::isOf(const std::string& title, const std::string& origin)
{
    std::string line;
    if (!std::getline(m_in, line) || line != title) return false;
    const auto found = readRecord();
    return found && std::string(found->begin(), found->end()) == origin;
}

void RecordJournal::begin(const std::string& title, const std::string& origin)
{
    if (ftruncate(m_descriptor, 0) != 0) failToWrite(m_file, errno);
    const std::string line = title + "\n";
    write(line.data(), line.size());
    append(Bytes(origin.begin(), origin.end()));
    syncFolderOf(m_file);
}

/** \return none at the end of the file, or where it was cut off */
std::optional<RecordJournal::Bytes> RecordJournal::readRecord()
{
    RecordHeader header;
    if (!m_in.read(reinterpret_cast<char*>(&header), sizeof(header))) return std::nullopt;
    if (static_cast<uint64_t>(m_in.tellg()) + header.size > m_size) return std::nullopt;
    Bytes bytes(header.size);
    const bool isRead =
        bytes.empty() || m_in.read(reinterpret_cast<char*>(bytes.data()), header.size);
    if (!isRead || checksumOf(bytes) != header.checksum) return std::nullopt;
    return bytes;
}

std::optional<RecordJournal::Bytes> RecordJournal::next()
{
    if (m_read == m_kept) return std::nullopt;
    ++m_read;
    auto record = readRecord();
    if (!record) throw InputError("cannot read " + m_file + " again: check the disk");
    return record;
}

void RecordJournal::append(const Bytes& record)
{
    const RecordHeader header{static_cast<uint32_t>(record.size()), checksumOf(record)};
    Bytes bytes(reinterpret_cast<const uint8_t*>(&header),
                reinterpret_cast<const uint8_t*>(&header + 1));
    bytes.insert(bytes.end(), record.begin(), record.end());
    write(bytes.data(), bytes.size());
    if (fsync(m_descriptor) != 0) failToWrite(m_file, errno);
}

void RecordJournal::write(const void* data, size_t size)
{
    const auto* at = static_cast<const uint8_t*>(data);
    while (size > 0) {
        const ssize_t written = ::write(m_descriptor, at, size);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) failToWrite(m_file, errno);
        at += written;
        size -= static_cast<size_t>(written);
    }
}

void RecordJournal::discard()
{
    unlink(m_file.c_str());
}
}  // namespace voxeland
