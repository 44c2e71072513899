// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** Work that is done piece by piece, kept in a file beside its output: a run that was stopped or
 * killed leaves it, and the next one goes on from there. What was appended is on the disk; a record
 * that was cut off is dropped. */
class RecordJournal
{
 public:
    using Bytes = std::vector<uint8_t>;

    /** Opens the file, or begins a new one where there is none of that title and origin.
     *  \param title what the records are, with the version of their format; one line
     *  \param origin what they depend on: only those of the same one are kept
     *  \throws OutputError if it cannot be written, or another run holds it,
     *  InputError if what there is cannot be read */
    RecordJournal(std::string file, const std::string& title, const std::string& origin);
    ~RecordJournal();
    RecordJournal(const RecordJournal&) = delete;
    RecordJournal& operator=(const RecordJournal&) = delete;

    [[nodiscard]] const std::string& file() const { return m_file; }
    /** Records of earlier runs. */
    [[nodiscard]] size_t kept() const { return m_kept; }
    /** The next one of those, in order; none behind the last. */
    std::optional<Bytes> next();
    /** Adds a record. \throws OutputError if it cannot be kept */
    void append(const Bytes& record);
    /** Removes the file: everything is done. */
    void discard();

 private:
    /** Opens the file; the destructor closes it, whatever comes. */
    explicit RecordJournal(std::string file);

    void begin(const std::string& title, const std::string& origin);
    void checkRead() const;
    bool isOf(const std::string& title, const std::string& origin);
    std::optional<Bytes> readRecord();
    void write(const void* data, size_t size);

    std::string m_file;
    int m_descriptor = -1;  //!< appends, and holds the lock
    std::ifstream m_in;
    uint64_t m_size = 0;  //!< of what earlier runs left
    size_t m_kept = 0, m_read = 0;
};
}  // namespace voxeland
