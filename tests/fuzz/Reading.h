// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "support/TestFiles.h"
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

/** A file of made-up content, in a folder of its own that is removed at the end. */
class MadeUpFile
{
 public:
    explicit MadeUpFile(const std::string& name) : m_path(m_folder.file(name)) {}

    [[nodiscard]] const std::string& path() const { return m_path; }
    /** The file's folder, for what belongs beside it. */
    [[nodiscard]] const test::TemporaryFolder& folder() const { return m_folder; }
    /** Path of the file, of this content now. */
    const std::string& holding(const uint8_t* data, size_t size) const;
    /** The same, of compressed content, as rawlogs and maps are: a fuzzer cannot guess a checksum.
     */
    const std::string& compressing(const uint8_t* data, size_t size) const;

 private:
    test::TemporaryFolder m_folder;
    std::string m_path;
};
}  // namespace voxeland::fuzz
