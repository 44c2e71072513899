// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <array>
#include <cstdint>

namespace voxeland
{
/** A set of the 512 cells of a block. */
class CellMask
{
 public:
    static constexpr int WORDS = BLOCK_CELLS / 64;

    void set(int cell) { m_words[static_cast<size_t>(cell >> 6)] |= bit(cell); }
    void reset(int cell) { m_words[static_cast<size_t>(cell >> 6)] &= ~bit(cell); }
    [[nodiscard]] bool test(int cell) const
    {
        return (m_words[static_cast<size_t>(cell >> 6)] & bit(cell)) != 0;
    }
    [[nodiscard]] int count() const
    {
        int n = 0;
        for (const uint64_t w : m_words) n += __builtin_popcountll(w);
        return n;
    }
    [[nodiscard]] bool any() const
    {
        for (const uint64_t w : m_words)
            if (w != 0) return true;
        return false;
    }
    /** How many cells of the set come before this one. */
    [[nodiscard]] int rank(int cell) const
    {
        int n = 0;
        const auto word = static_cast<size_t>(cell >> 6);
        for (size_t i = 0; i < word; ++i) n += __builtin_popcountll(m_words[i]);
        return n + __builtin_popcountll(m_words[word] & (bit(cell) - 1));
    }
    /** Calls f(cell) for each cell of the set, in increasing order. */
    template <typename F>
    void forEach(F&& f) const
    {
        for (size_t i = 0; i < WORDS; ++i)
            for (uint64_t w = m_words[i]; w != 0; w &= w - 1)
                f(static_cast<int>(64 * i) + __builtin_ctzll(w));
    }

    [[nodiscard]] uint64_t word(int i) const { return m_words[static_cast<size_t>(i)]; }
    void setWord(int i, uint64_t w) { m_words[static_cast<size_t>(i)] = w; }

    friend CellMask operator|(const CellMask& a, const CellMask& b)
    {
        return combined(a, b, [](uint64_t x, uint64_t y) { return x | y; });
    }
    friend CellMask operator&(const CellMask& a, const CellMask& b)
    {
        return combined(a, b, [](uint64_t x, uint64_t y) { return x & y; });
    }
    /** Cells of `a` that are not in `b`. */
    friend CellMask operator-(const CellMask& a, const CellMask& b)
    {
        return combined(a, b, [](uint64_t x, uint64_t y) { return x & ~y; });
    }
    friend bool operator==(const CellMask& a, const CellMask& b) { return a.m_words == b.m_words; }

 private:
    static uint64_t bit(int cell) { return uint64_t{1} << (cell & 63); }
    template <typename Op>
    static CellMask combined(const CellMask& a, const CellMask& b, Op op)
    {
        CellMask r;
        for (size_t i = 0; i < WORDS; ++i) r.m_words[i] = op(a.m_words[i], b.m_words[i]);
        return r;
    }

    std::array<uint64_t, WORDS> m_words{};
};
}  // namespace voxeland
