// SPDX-License-Identifier: BSD-3-Clause
#include "ImageName.h"

#include "voxeland/numbers.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace voxeland
{
namespace
{
const std::string DIGITS = "0123456789";

std::string withoutEnding(const std::string& path)
{
    static const std::regex ENDING(R"(\.(jpe?g|png|bmp|tiff?|webp|ppm|pgm)$)", std::regex::icase);
    return std::regex_replace(path, ENDING, "");
}
}  // namespace

std::vector<std::string> imagePath(const std::string& path)
{
    std::vector<std::string> parts;
    std::string part;
    const auto flush = [&] {
        if (!part.empty() && part != ".") parts.push_back(part);
        part.clear();
    };
    for (const char c : withoutEnding(path)) {
        if (c == '/' || c == '\\')
            flush();
        else
            part += c;
    }
    flush();
    for (std::string& p : parts)
        for (char& c : p)
            if (static_cast<unsigned char>(c) < 0x80 &&
                std::isalnum(static_cast<unsigned char>(c)) == 0)
                c = '_';
    std::reverse(parts.begin(), parts.end());
    return parts;
}

std::string beforeRoboflow(const std::string& path)
{
    static const std::regex HASH(R"((_(jpe?g|png))?\.rf\.[0-9a-zA-Z]+)");
    return std::regex_replace(path, HASH, "");
}

std::string beforeLabelStudio(const std::string& path)
{
    static const std::regex PREFIX(R"((^|[/\\])[0-9a-f]{8}-([^/\\]*)$)");
    return std::regex_replace(path, PREFIX, "$1$2");
}

std::optional<int64_t> numberIn(const std::string& path)
{
    const auto parts = imagePath(beforeRoboflow(path));
    if (parts.empty()) return std::nullopt;
    const std::string& name = parts.front();
    const size_t last = name.find_last_of(DIGITS);
    if (last == std::string::npos) return std::nullopt;
    const size_t before = name.find_last_not_of(DIGITS, last);
    const size_t first = before == std::string::npos ? 0 : before + 1;
    return parsed<int64_t>(name.substr(first, last + 1 - first));
}

std::optional<int64_t> numberThatIs(const std::string& path)
{
    const auto parts = imagePath(path);
    return parts.empty() ? std::nullopt : parsed<int64_t>(parts.front());
}
}  // namespace voxeland
