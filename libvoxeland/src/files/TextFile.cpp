// SPDX-License-Identifier: BSD-3-Clause
#include "TextFile.h"

#include "voxeland/base/errors.h"
#include "voxeland/files/InputFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace voxeland
{
namespace
{
bool beginsWith(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}

}  // namespace

std::string plainText(std::string text)
{
    const std::string MARK = "\xEF\xBB\xBF";
    if (beginsWith(text, MARK)) text.erase(0, MARK.size());
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) text[i] = '\n';
    return text;
}

std::string readTextFile(const std::string& file, const std::string& purpose)
{
    checkInputFile(file, "the " + purpose);
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw InputError("cannot read the " + purpose + " " + file + ": " + std::strerror(errno));
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (beginsWith(text, "\xFF\xFE") || beginsWith(text, "\xFE\xFF"))
        throw InputError("the " + purpose + " " + file + " is UTF-16 text: save it as UTF-8");
    if (beginsWith(text, "PK\x03\x04") || beginsWith(text, "\xD0\xCF\x11\xE0"))
        throw InputError("the " + purpose + " " + file + " is a spreadsheet: save it as CSV");
    return plainText(std::move(text));
}
}  // namespace voxeland
