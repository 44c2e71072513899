// SPDX-License-Identifier: BSD-3-Clause
#include "ImageName.h"

#include "voxeland/base/lowerCase.h"
#include "voxeland/base/numbers.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace voxeland
{
namespace
{
const std::string DIGITS = "0123456789";

bool isIn(const std::string& word, std::initializer_list<const char*> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/** In front of the ending of a file that is an image; npos if there is none. */
size_t endingOf(const std::string& path)
{
    const size_t point = path.rfind('.');
    if (point == std::string::npos) return point;
    const std::string ending = lowerCase(path.substr(point + 1));
    const bool isImage =
        isIn(ending, {"jpg", "jpeg", "png", "bmp", "tif", "tiff", "webp", "ppm", "pgm"});
    return isImage ? point : std::string::npos;
}

/** Also without what follows the ending in an address, "a.jpg?width=640". */
std::string withoutEnding(const std::string& path)
{
    const std::string file = path.substr(0, path.find('?'));
    const size_t ending = endingOf(file);
    return ending != std::string::npos ? file.substr(0, ending) : path.substr(0, endingOf(path));
}

/** A path's numbers, which compare as such, and what is around them. */
struct Numerals
{
    std::string around;
    std::vector<std::pair<size_t, std::string>> numbers;  //!< digits, behind how many these are
};

Numerals numeralsOf(const std::string& path)
{
    Numerals result;
    for (size_t at = 0; at < path.size();) {
        const size_t end = std::min(path.size(), path.find_first_not_of(DIGITS, at));
        if (end == at) {
            result.around += path[at++];
            continue;
        }
        const size_t first = std::min(path.find_first_not_of('0', at), end);
        result.numbers.emplace_back(end - first, path.substr(first, end - first));
        result.around += '0';
        at = end;
    }
    return result;
}

std::string beforeAnnotation(const std::string& path)
{
    return withoutEnding(beforeRoboflow(beforeLabelStudio(path)));
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
            if (static_cast<unsigned char>(c) < 0x80)
                c = std::isalnum(static_cast<unsigned char>(c)) == 0
                        ? '_'
                        : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::reverse(parts.begin(), parts.end());
    return parts;
}

std::string beforeRoboflow(const std::string& path)
{
    static const std::string MARK = ".rf.", ALNUM = DIGITS + "abcdefghijklmnopqrstuvwxyz" +
                                                    "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    std::string name;
    size_t copied = 0;
    for (size_t at = 0; (at = path.find(MARK, at)) != std::string::npos;) {
        const size_t hash = at + MARK.size();
        const size_t end = std::min(path.size(), path.find_first_not_of(ALNUM, hash));
        if (end > hash) {
            name.append(path, copied, at - copied);
            const size_t mark = name.rfind('_');
            if (mark != std::string::npos && isIn(name.substr(mark), {"_jpg", "_jpeg", "_png"}))
                name.resize(mark);
            copied = end;
        }
        at = end;
    }
    return name.append(path, copied);
}

std::string beforeLabelStudio(const std::string& path)
{
    constexpr size_t HASH = 8;
    const size_t slash = path.find_last_of("/\\");
    const size_t name = slash == std::string::npos ? 0 : slash + 1;
    const bool isHashed =
        path.find_first_not_of("0123456789abcdef", name) == name + HASH && path[name + HASH] == '-';
    return isHashed ? std::string(path).erase(name, HASH + 1) : path;
}

bool isStem(const std::string& text)
{
    return !text.empty() && text.find_first_of("/\\") == std::string::npos &&
           withoutEnding(text) == text && !parsed<int64_t>(text);
}

bool comesBefore(const std::string& path, const std::string& other)
{
    const std::string a = beforeAnnotation(path), b = beforeAnnotation(other);
    const size_t nameOfA = a.find_last_of("/\\") + 1, nameOfB = b.find_last_of("/\\") + 1;
    if (a.substr(0, nameOfA) == b.substr(0, nameOfB)) {
        const std::string first = a.substr(nameOfA), second = b.substr(nameOfB);
        const bool areWhole = parsed<int64_t>(first) && parsed<int64_t>(second);
        const auto x = parsed<double>(first), y = parsed<double>(second);
        if (!areWhole && x && y) return *x < *y;
    }
    const Numerals x = numeralsOf(a), y = numeralsOf(b);
    return x.around == y.around && x.numbers < y.numbers;
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
