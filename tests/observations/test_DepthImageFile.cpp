// SPDX-License-Identifier: BSD-3-Clause
#include "observations/DepthImageFile.h"
#include "support/Frames.h"
#include "support/TestFiles.h"
#include "voxeland/observations/UnusableFrame.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

#include <filesystem>
#include <zlib.h>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
/** A scan whose depth image MRPT has put into a file of its own. */
class DepthImageFile : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        m_scan = test::makeScan([](int c, int r) { return 1 + 0.004 * c + 0.003 * r; });
        m_depths = m_scan->rangeImage;
        mrpt::img::CImage::setImagesPathBase(m_folder.path().string());
        m_scan->rangeImage_convertToExternalStorage("depth", m_folder.path().string() + "/");
        m_file = m_scan->rangeImage_getExternalStorageFileAbsolutePath("");
        m_content = test::readFile(m_file);
    }
    void TearDown() override { mrpt::img::CImage::setImagesPathBase("."); }

    [[nodiscard]] std::string refusal() const
    {
        try {
            loadDepthImage(*m_scan);
        } catch (const UnusableFrame& e) {
            return e.what();
        }
        return "";
    }
    void expectRefusal(const std::string& content, const std::string& what)
    {
        test::writeFile(m_file, content);
        EXPECT_NE(refusal().find(fs::path(m_file).filename().string()), std::string::npos) << what;
    }
    /** The same bytes in gzip. */
    [[nodiscard]] std::string compressed(const std::string& bytes) const
    {
        const std::string file = m_folder.file("compressed");
        const gzFile out = gzopen(file.c_str(), "wb");
        gzwrite(out, bytes.data(), static_cast<unsigned>(bytes.size()));
        gzclose(out);
        return test::readFile(file);
    }

    test::TemporaryFolder m_folder;
    std::shared_ptr<mrpt::obs::CObservation3DRangeScan> m_scan;
    mrpt::math::CMatrix_u16 m_depths;
    std::string m_file, m_content;
};
}  // namespace

TEST_F(DepthImageFile, IsReadAsMrptWroteIt)
{
    EXPECT_EQ(m_scan->rangeImage.size(), 0) << "MRPT keeps it in the file alone";
    EXPECT_EQ(refusal(), "");
    EXPECT_EQ(m_scan->rangeImage, m_depths);
}

TEST_F(DepthImageFile, CutOffAnywhereItIsRefused)
{
    for (size_t size = 0; size < m_content.size(); size += 1 + m_content.size() / 50)
        expectRefusal(m_content.substr(0, size), std::to_string(size) + " bytes");
    expectRefusal(m_content.substr(0, m_content.size() - 1), "all but the last byte");
}

TEST_F(DepthImageFile, FlippedBitsAndOtherFilesAreRefused)
{
    for (size_t at = 20; at < m_content.size(); at += m_content.size() / 20) {
        std::string damaged = m_content;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        expectRefusal(damaged, "a bit of byte " + std::to_string(at));
    }
    expectRefusal("<html><head><title>404 Not Found</title></head></html>", "a page");
    expectRefusal("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\n", "a pointer");
    expectRefusal(std::string(5000, '\0'), "zeros");
    expectRefusal(compressed(std::string("\xff\xff\xff\x7f\xff\xff\xff\x7f", 8)), "sizes alone");
    expectRefusal(compressed(std::string("\0\0\1\0\0\1\0\0", 8)), "32 million pixels of nothing");
    expectRefusal(compressed(std::string("\x02\0\0\0\x02\0\0\0ababababX", 17)),
                  "more than it says");
    fs::remove(m_file);
    EXPECT_NE(refusal(), "");
}
