// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdarg>
#include <cstdio>
#include <locale.h>
#include <string>

namespace voxeland
{
/** While it lives, C's functions write and read numbers in this thread without a locale: for what
 * other libraries format and parse. Our own numbers are written by voxeland/numbers.h. */
class ClassicNumbers
{
 public:
    ClassicNumbers() : m_before(uselocale(classic())) {}
    ~ClassicNumbers() { uselocale(m_before); }
    ClassicNumbers(const ClassicNumbers&) = delete;
    ClassicNumbers& operator=(const ClassicNumbers&) = delete;

 private:
    static locale_t classic()
    {
        static const locale_t c = newlocale(LC_ALL_MASK, "C", nullptr);
        return c;
    }

    locale_t m_before;
};

/** Text as std::printf() would print it, without a locale. */
[[gnu::format(printf, 1, 2)]] inline std::string format(const char* pattern, ...)
{
    const ClassicNumbers here;
    va_list values, again;
    va_start(values, pattern);
    va_copy(again, values);
    std::string text(static_cast<size_t>(std::vsnprintf(nullptr, 0, pattern, values)), '\0');
    std::vsnprintf(text.data(), text.size() + 1, pattern, again);
    va_end(again);
    va_end(values);
    return text;
}
}  // namespace voxeland
