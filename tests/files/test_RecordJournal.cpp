// SPDX-License-Identifier: BSD-3-Clause
#include "files/RecordJournal.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

#include <functional>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <utility>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace
{
std::function<void()> beforeLocking;  // what another run does just before this one has the lock
}

extern "C" int flock(int file, int operation) noexcept
{
    if (const auto other = std::exchange(beforeLocking, nullptr)) other();
    return static_cast<int>(syscall(SYS_flock, file, operation));
}

namespace
{
class ARecordJournal : public testing::Test
{
 protected:
    TemporaryFolder m_folder;
    const std::string m_file = m_folder.file("journal");
    const RecordJournal::Bytes m_record = {1, 2, 3};

    [[nodiscard]] RecordJournal opened() const { return RecordJournal(m_file, "title", "origin"); }
};
}  // namespace

TEST_F(ARecordJournal, KeepsWhatAnotherRunAddsBeforeItsEnd)
{
    opened().append(m_record);
    beforeLocking = [&] { opened().append(m_record); };
    RecordJournal journal = opened();
    EXPECT_EQ(journal.kept(), 2u);
    EXPECT_EQ(journal.next(), m_record);
}

TEST_F(ARecordJournal, ThatAnotherRunRemovesIsNotWrittenTo)
{
    opened().append(m_record);
    beforeLocking = [&] { opened().discard(); };
    EXPECT_THROW(opened(), OutputError);
    EXPECT_FALSE(fs::exists(m_file));
    EXPECT_EQ(opened().kept(), 0u);
}

TEST_F(ARecordJournal, ReadsTheFileThatItHasLocked)
{
    opened().append(m_record);
    beforeLocking = [&] {
        fs::rename(m_file, m_file + "2");
        test::writeFile(m_file, "another");
    };
    EXPECT_EQ(opened().kept(), 1u);
}
