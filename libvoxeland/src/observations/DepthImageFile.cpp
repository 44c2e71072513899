// SPDX-License-Identifier: BSD-3-Clause
#include "DepthImageFile.h"

#include "voxeland/base/RefusedMemory.h"
#include "voxeland/files/InputFile.h"
#include "voxeland/observations/UnusableFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cerrno>
#include <cstdint>
#include <memory>
#include <zlib.h>

using mrpt::obs::CObservation3DRangeScan;

namespace voxeland
{
namespace
{
/** Bytes of a gzip file, which is right to its end or not at all. */
class GzBytes
{
 public:
    explicit GzBytes(const std::string& file) : m_in(gzopen(file.c_str(), "rb"), gzclose)
    {
        if (m_in) gzbuffer(m_in.get(), 1 << 17);
    }

    /** \return false if it ends before that, or is damaged */
    bool read(void* to, size_t bytes)
    {
        return m_in &&
               gzread(m_in.get(), to, static_cast<unsigned>(bytes)) == static_cast<int>(bytes);
    }
    /** Whether this is its end, and all that was read fits the file's checksum. */
    bool endsWell()
    {
        char more = 0;
        int error = Z_OK;
        const bool isEnd = m_in && gzread(m_in.get(), &more, 1) == 0;
        if (isEnd) gzerror(m_in.get(), &error);
        return isEnd && error == Z_OK && gzdirect(m_in.get()) == 0;
    }

 private:
    std::unique_ptr<gzFile_s, int (*)(gzFile)> m_in;
};

bool readInto(CObservation3DRangeScan& scan, const std::string& file)
{
    constexpr uint64_t MOST_PIXELS = 1 << 25;
    GzBytes in(file);
    uint32_t size[2] = {0, 0};
    if (!in.read(size, sizeof(size))) return false;
    const auto [rows, columns] = size;
    if (rows > MOST_PIXELS || columns > MOST_PIXELS || uint64_t{rows} * columns > MOST_PIXELS)
        return false;
    scan.rangeImage.setSize(static_cast<int>(rows), static_cast<int>(columns));
    const auto pixels = static_cast<size_t>(scan.rangeImage.size());
    if (pixels > 0 && !in.read(scan.rangeImage.data(), pixels * sizeof(uint16_t))) return false;
    return in.endsWell();
}
}  // namespace

void loadDepthImage(const CObservation3DRangeScan& scan)
{
    if (!scan.hasRangeImage || !scan.rangeImage_isExternallyStored()) return;
    const std::string file = scan.rangeImage_getExternalStorageFileAbsolutePath("");
    bool isRead = false;
    errno = 0;
    try {
        checkInputFile(file, "the depth image");
        const bool isText = file.size() > 4 && file.compare(file.size() - 4, 4, ".txt") == 0;
        if (isText) scan.load();
        // As MRPT's load() does: what a scan keeps in a file is part of it.
        isRead = isText || readInto(const_cast<CObservation3DRangeScan&>(scan), file);
    } catch (const std::exception&) {
        isRead = false;
    }
    if (isRead) return;
    RefusedMemory::noteErrno();
    throw UnusableFrame("the depth image '" + file +
                        "' is missing or damaged: restore the rawlog's folder of images");
}
}  // namespace voxeland
