// SPDX-License-Identifier: BSD-3-Clause
#include "Csv.h"

#include "voxeland/counted.h"
#include "voxeland/errors.h"
#include "voxeland/joined.h"
#include "voxeland/trimmed.h"

#include <sstream>

namespace voxeland
{
namespace
{
std::vector<std::string> fieldsOf(const std::string& line)
{
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            fields.back() += line[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += c;
    }
    for (std::string& f : fields) f = trimmed(f);
    return fields;
}
}  // namespace

std::vector<std::vector<std::string>> parseCsv(const std::string& text,
                                               const std::vector<std::string>& header,
                                               const std::string& source)
{
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    if (fieldsOf(line) != header)
        throw InputError(source + " must begin with the line '" + joined(header, ",") + "'.");
    std::vector<std::vector<std::string>> rows;
    for (size_t number = 2; std::getline(in, line); ++number) {
        if (trimmed(line).empty()) continue;
        rows.push_back(fieldsOf(line));
        if (rows.back().size() != header.size())
            throw InputError("line " + std::to_string(number) + " of " + source + " has " +
                             counted(rows.back().size(), "field") + " instead of " +
                             std::to_string(header.size()) + ".");
    }
    return rows;
}
}  // namespace voxeland
