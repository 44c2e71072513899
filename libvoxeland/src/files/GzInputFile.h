// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CSerializable.h>

#include <atomic>
#include <limits>
#include <string>

struct gzFile_s;

namespace voxeland
{
/** A file of MRPT objects, gzip or not, such as a rawlog. Unlike MRPT's own reading loops it tells
 *  the end of the file from a file that is cut off or damaged. */
class GzInputFile : public mrpt::io::CStream
{
 public:
    /** \throws InputError if the file cannot be opened */
    explicit GzInputFile(const std::string& file);
    ~GzInputFile() override;
    GzInputFile(const GzInputFile&) = delete;
    GzInputFile& operator=(const GzInputFile&) = delete;

    /** Next object, or null at the end of the file. What it takes of memory is limited to 1 GiB, or
     *  50 times the size of the file.
     *  \throws InputError if the file is cut off, damaged, or holds an object of unknown class */
    mrpt::serialization::CSerializable::Ptr readObject();
    /** Keeps all of objectBytes() from now on, and not only how they begin. */
    void keepObjectBytes() { m_mostKept = std::numeric_limits<size_t>::max(); }
    /** The object last read as it is in the file (uncompressed). */
    [[nodiscard]] const std::string& objectBytes() const { return m_objectBytes; }

    /** How many of the pictures read so far are damaged: parts of them are grey or wrong,
     *  or nothing is left of them. */
    [[nodiscard]] uint64_t damagedPictures() const { return m_damagedPictures; }

    /** How much of the file had been read after the last object, in [0,1]. From any thread. */
    [[nodiscard]] double progress() const { return m_progress; }

    /** \return bytes read: fewer than asked for only at the end of the file
     *  \throws InputError if the file is cut off or damaged */
    size_t Read(void* data, size_t bytes) override;
    /** Uncompressed bytes read so far. */
    [[nodiscard]] uint64_t getPosition() const override { return m_position; }

    /** \name Not for input files: writing and seeking throw std::logic_error
     * @{ */
    size_t Write(const void*, size_t) override;
    uint64_t Seek(int64_t, TSeekOrigin) override;
    /** Size of the file on disk. */
    [[nodiscard]] uint64_t getTotalBytesCount() const override { return m_fileSize; }
    /** @} */

 private:
    bool isAtEnd();
    /** What zlib says of the file. */
    [[noreturn]] void fail() const;
    void updateProgress();

    std::string m_name;
    std::string m_objectBytes;
    size_t m_mostKept = 256;  //!< of the object's bytes: its class and version
    gzFile_s* m_file = nullptr;
    uint64_t m_position = 0, m_fileSize = 0, m_damagedPictures = 0;
    std::atomic<double> m_progress{0};
};
}  // namespace voxeland
