// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <clocale>
#include <locale>
#include <string>

namespace voxeland::test
{
/** While it lives, the process writes numbers as in German, 1.234,5: streams always, C's functions
 * where the system has such a locale. */
class GermanNumbers
{
 public:
    GermanNumbers()
        : m_streams(std::locale::global(std::locale(std::locale(), new Punctuation))),
          m_functions(std::setlocale(LC_ALL, nullptr))
    {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"})
            m_complete = m_complete || std::setlocale(LC_ALL, name) != nullptr;
    }
    ~GermanNumbers()
    {
        std::locale::global(m_streams);
        std::setlocale(LC_ALL, m_functions.c_str());
    }
    GermanNumbers(const GermanNumbers&) = delete;
    GermanNumbers& operator=(const GermanNumbers&) = delete;

    /** Whether C's functions do so, too. */
    [[nodiscard]] bool isComplete() const { return m_complete; }

 private:
    struct Punctuation : std::numpunct<char>
    {
        [[nodiscard]] char do_decimal_point() const override { return ','; }
        [[nodiscard]] char do_thousands_sep() const override { return '.'; }
        [[nodiscard]] std::string do_grouping() const override { return "\3"; }
    };

    std::locale m_streams;
    std::string m_functions;
    bool m_complete = false;
};
}  // namespace voxeland::test
