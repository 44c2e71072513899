// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/PixelBox.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voxeland
{
/** Binary image stored as the lengths of its runs in row-major order: alternately unset and set
 *  pixels, unset first (that run may be empty). Immutable; a mask of 640x480 takes about 1 kB. */
class RunLengthMask
{
 public:
    static constexpr uint64_t MOST_PIXELS = uint64_t{1} << 27;  //!< of an image: 134 million

    RunLengthMask() = default;

    /** \param runs run lengths, their sum being width*height
     *  \throws std::invalid_argument if they do not add up, or a size is negative or too great */
    RunLengthMask(int width, int height, std::vector<uint32_t> runs);

    /** \param pixels width*height bytes, row-major; non-zero is set */
    static RunLengthMask fromBitmap(const uint8_t* pixels, int width, int height);

    /** width*height bytes, row-major, 0 or 1. */
    [[nodiscard]] std::vector<uint8_t> toBitmap() const;

    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    [[nodiscard]] const std::vector<uint32_t>& runs() const { return m_runs; }
    [[nodiscard]] bool empty() const { return area() == 0; }

    /** Number of set pixels. */
    [[nodiscard]] uint64_t area() const;
    /** Smallest rectangle around the set pixels; width and height 0 if there are none. */
    [[nodiscard]] PixelBox boundingBox() const;

    /** Calls f(first, last) for each run of set pixels, as row-major pixel numbers [first, last);
     *  a run may go on over the ends of rows. */
    template <typename F>
    void forEachRun(F&& f) const
    {
        uint32_t at = 0;
        for (size_t i = 0; i < m_runs.size(); ++i) {
            if (i % 2 == 1 && m_runs[i] > 0) f(at, at + m_runs[i]);
            at += m_runs[i];
        }
    }

    friend bool operator==(const RunLengthMask& a, const RunLengthMask& b)
    {
        return a.m_width == b.m_width && a.m_height == b.m_height && a.m_runs == b.m_runs;
    }

 private:
    int m_width = 0, m_height = 0;
    std::vector<uint32_t> m_runs;
};
}  // namespace voxeland
