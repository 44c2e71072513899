// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

/** \file
 * Numbers in text, written and read alike whatever locale a program has set: "1.5", never "1,5". */
namespace voxeland
{
/** The number that the whole text is, without blanks: "1.5", "-2e3", "+4", "nan", "inf". Nothing if
 *  it is none, or beyond the range of Number (double or an integer type). */
template <typename Number>
std::optional<Number> parsed(std::string_view text)
{
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end) return std::nullopt;
    return value;
}

/** Shortest of the texts of 6 to 17 digits that reads back as the same number. */
inline std::string numberText(double value)
{
    constexpr int LEAST = 6, MOST = std::numeric_limits<double>::max_digits10;
    std::string text;
    for (int digits = LEAST; digits <= MOST; ++digits) {
        char buffer[40];
        const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value,
                                       std::chars_format::general, digits)
                             .ptr;
        text.assign(buffer, end);
        if (parsed<double>(text) == value) break;
    }
    return text;
}

/** A length to the micrometre, without the last digits of products such as 19773 * 0.05. */
inline std::string metresText(double metres)
{
    constexpr double MICROMETRES = 1e6;
    return numberText(std::round(metres * MICROMETRES) / MICROMETRES);
}

/** A number with so many decimals: fixedText(2.5, 2) is "2.50". */
inline std::string fixedText(double value, int decimals)
{
    char buffer[400];
    const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    return {buffer, end};
}
}  // namespace voxeland
