// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"

#include <cstddef>
#include <string>

namespace voxeland
{
/** Odd entries of an input that otherwise can be used: each is left out and counted, and the first
 *  one is named. With --strict each is an error. */
class LeftOut
{
 public:
    /** \param strict an odd entry is an error instead */
    explicit LeftOut(bool strict = false) : m_strict(strict) {}

    /** \param sentence which entry of which file, and what is wrong with it
     *  \throws InputError with that sentence if strict, std::bad_alloc if memory was refused: the
     *  entry may be fine */
    void add(const std::string& sentence)
    {
        RefusedMemory::check();
        if (m_strict) throw InputError(sentence);
        if (m_count++ == 0) m_first = sentence;
    }

    [[nodiscard]] size_t count() const { return m_count; }
    /** What was said of the first one; empty if there is none. */
    [[nodiscard]] const std::string& first() const { return m_first; }
    /** All of it in a sentence, for a warning where count() > 0.
     *  \param one,many what the entries are, see counted() */
    [[nodiscard]] std::string told(const std::string& one, const std::string& many = "") const
    {
        return counted(m_count, one, many) +
               " left out (--strict: an error), the first: " + m_first;
    }

 private:
    bool m_strict;
    size_t m_count = 0;
    std::string m_first;
};
}  // namespace voxeland
