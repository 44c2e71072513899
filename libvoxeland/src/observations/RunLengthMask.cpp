// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/RunLengthMask.h"

#include "base/sizeText.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace voxeland
{
RunLengthMask::RunLengthMask(int width, int height, std::vector<uint32_t> runs)
    : m_width(width), m_height(height), m_runs(std::move(runs))
{
    const uint64_t pixels = std::accumulate(m_runs.begin(), m_runs.end(), uint64_t{0});
    if (pixels > MOST_PIXELS)
        throw std::invalid_argument("mask of " + sizeText(width, height) +
                                    " pixels is larger than an image of " +
                                    std::to_string(MOST_PIXELS / 1000000) + " megapixels");
    if (width < 0 || height < 0 ||
        pixels != static_cast<uint64_t>(width) * static_cast<uint64_t>(height))
        throw std::invalid_argument("mask of " + sizeText(width, height) + " pixels has runs for " +
                                    std::to_string(pixels));
}

RunLengthMask RunLengthMask::fromBitmap(const uint8_t* pixels, int width, int height)
{
    const size_t n = static_cast<size_t>(width) * static_cast<size_t>(height);
    std::vector<uint32_t> runs;
    bool set = false;
    uint32_t length = 0;
    for (size_t i = 0; i < n; ++i) {
        if ((pixels[i] != 0) != set) {
            runs.push_back(length);
            length = 0;
            set = !set;
        }
        ++length;
    }
    runs.push_back(length);
    return {width, height, std::move(runs)};
}

std::vector<uint8_t> RunLengthMask::toBitmap() const
{
    std::vector<uint8_t> pixels(static_cast<size_t>(m_width) * static_cast<size_t>(m_height), 0);
    forEachRun([&](uint32_t first, uint32_t last) {
        std::fill(pixels.begin() + first, pixels.begin() + last, uint8_t{1});
    });
    return pixels;
}

uint64_t RunLengthMask::area() const
{
    uint64_t n = 0;
    for (size_t i = 1; i < m_runs.size(); i += 2) n += m_runs[i];
    return n;
}

PixelBox RunLengthMask::boundingBox() const
{
    int left = m_width, right = -1, top = m_height, bottom = -1;
    forEachRun([&](uint32_t first, uint32_t last) {
        const auto w = static_cast<uint32_t>(m_width);
        const int firstRow = static_cast<int>(first / w),
                  lastRow = static_cast<int>((last - 1) / w);
        top = std::min(top, firstRow);
        bottom = std::max(bottom, lastRow);
        const bool wraps = firstRow != lastRow;
        left = wraps ? 0 : std::min(left, static_cast<int>(first % w));
        right = wraps ? m_width - 1 : std::max(right, static_cast<int>((last - 1) % w));
    });
    if (right < 0) return {};
    return {left, top, right - left + 1, bottom - top + 1};
}
}  // namespace voxeland
