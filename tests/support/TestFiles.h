// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace voxeland::test
{
/** A folder of its own for one test, removed with everything in it at the end. */
class TemporaryFolder
{
 public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    /** Path of a file inside, as text. */
    [[nodiscard]] std::string file(const std::string& name) const
    {
        return (m_path / name).string();
    }

 private:
    std::filesystem::path m_path;
};

/** The real RGB-D frames with a real network's predictions, or an empty path where absent. */
[[nodiscard]] std::filesystem::path redkitchen();

/** Whole content of a file; throws std::runtime_error if it cannot be read. */
[[nodiscard]] std::string readFile(const std::filesystem::path& file);
/** Replaces the content of a file; throws std::runtime_error if it cannot be written. */
void writeFile(const std::filesystem::path& file, const std::string& content);
}  // namespace voxeland::test

/** Ends a test as SKIPPED on machines without the real data. */
#define SKIP_WITHOUT_REDKITCHEN() \
    if (voxeland::test::redkitchen().empty()) GTEST_SKIP() << "no real data on this machine"
