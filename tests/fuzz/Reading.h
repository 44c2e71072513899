// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/errors.h"

#include <cstdint>
#include <functional>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace voxeland::fuzz
{
/** Reads input that somebody made up. It may be refused, by one of the errors that programs know,
 *  in a sentence of at most 1000 characters; anything else ends the process, and is a find.
 *  \return 0, which says that the input may serve for further ones */
int readOrRefuse(const std::function<void()>& read);

/** A file of made-up content, in a folder of its own that is removed at the end. That is in the
 *  current folder: the path is the same each time, and so is what a fuzzer sees of the code. */
class MadeUpFile
{
 public:
    explicit MadeUpFile(const std::string& name);
    ~MadeUpFile();
    MadeUpFile(const MadeUpFile&) = delete;
    MadeUpFile& operator=(const MadeUpFile&) = delete;

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] const std::string& folder() const { return m_folder; }
    /** Path of another file in the folder. */
    [[nodiscard]] std::string beside(const std::string& name) const;
    /** Path of the file, of this content now. */
    const std::string& holding(const uint8_t* data, size_t size) const;
    /** The same, of compressed content, as rawlogs and maps are: a fuzzer cannot guess a checksum.
     */
    const std::string& compressing(const uint8_t* data, size_t size) const;

 private:
    std::string m_folder, m_path;
};
}  // namespace voxeland::fuzz
