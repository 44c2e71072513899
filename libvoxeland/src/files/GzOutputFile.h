// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/io/CStream.h>

#include <string>

struct gzFile_s;

namespace mrpt::serialization
{
class CSerializable;
}

namespace voxeland
{
/** A gzip file for MRPT archives to write to. Unlike mrpt::io::CFileGZOutputStream it notices a
 *  full disk also where data leave zlib's buffer late, in close(). */
class GzOutputFile : public mrpt::io::CStream
{
 public:
    static constexpr int FASTEST = 1;  //!< level of compression; MRPT's default

    /** \param compressionLevel 0 (none) to 9
     *  \param told name of the file in messages, where its own is a temporary one; empty: its own
     *  \throws OutputError if the file cannot be created */
    explicit GzOutputFile(const std::string& file, int compressionLevel = FASTEST,
                          const std::string& told = "");
    /** Closes without a check: call close() to know. */
    ~GzOutputFile() override;
    GzOutputFile(const GzOutputFile&) = delete;
    GzOutputFile& operator=(const GzOutputFile&) = delete;

    /** \throws OutputError if not all could be written */
    size_t Write(const void* data, size_t bytes) override;
    /** Appends an MRPT object. \throws OutputError if not all could be written */
    void writeObject(const mrpt::serialization::CSerializable& object);
    /** Writes what is still buffered; \throws OutputError if that fails */
    void close();

    /** Uncompressed bytes written so far. */
    [[nodiscard]] uint64_t getPosition() const override { return m_position; }

    /** \name Not for output files: reading and seeking throw std::logic_error
     * @{ */
    size_t Read(void*, size_t) override;
    uint64_t Seek(int64_t, TSeekOrigin) override;
    [[nodiscard]] uint64_t getTotalBytesCount() const override { return m_position; }
    /** @} */

 private:
    [[noreturn]] void fail();

    std::string m_name;
    std::string m_failure;  //!< why a write failed: MRPT's archives rewrap what Write() throws
    gzFile_s* m_file = nullptr;
    uint64_t m_position = 0;
};

/** Writes a file of one MRPT object through AtomicFile.
 *  \throws OutputError, naming the file, if not all of it could be written */
void writeAtomically(const std::string& file, const mrpt::serialization::CSerializable& object);
}  // namespace voxeland
