// SPDX-License-Identifier: BSD-3-Clause
#include "common/AsTyped.h"

#include "voxeland/base/joined.h"
#include "voxeland/base/printable.h"

#include <cstdint>
#include <cstdio>

namespace voxeland::apps
{
namespace
{
constexpr const char* PLAIN =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:,+@%";

std::string quoted(const std::string& word)
{
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string escaped(const std::string& word)
{
    std::string text = "$'";
    for (const char c : word) {
        char byte[5];
        std::snprintf(byte, sizeof(byte), "\\x%02x", static_cast<uint8_t>(c));
        const bool plain = c > ' ' && c < '\x7f' && c != '\'' && c != '\\';
        text += plain ? std::string(1, c) : byte;
    }
    return text + "'";
}

std::string typed(const std::string& word)
{
    if (!word.empty() && word.find_first_not_of(PLAIN) == std::string::npos) return word;
    return isPrintable(word) ? quoted(word) : escaped(word);
}
}  // namespace

std::string asTyped(const std::vector<std::string>& words)
{
    std::vector<std::string> command;
    for (const std::string& word : words) command.push_back(typed(word));
    return joined(command, " ");
}
}  // namespace voxeland::apps
