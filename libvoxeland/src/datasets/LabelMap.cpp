// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/LabelMap.h"

#include "files/Csv.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"

#include <algorithm>
#include <cctype>

namespace voxeland
{
extern const char* const PAPER9_CSV;  // share/labels/paper9.csv, embedded by CMake

namespace
{
const std::vector<std::string> HEADER = {"name", "class"};

std::string normalized(std::string name)
{
    for (char& c : name)
        c = c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}
}  // namespace

LabelMap::LabelMap(const std::string& csv, std::string source) : m_source(std::move(source))
{
    for (const CsvRow& row : parseCsv(csv, HEADER, "the label map " + m_source)) {
        const std::string &name = row.fields[0], &label = row.fields[1];
        const auto at = std::find(m_classes.begin(), m_classes.end(), label);
        const auto id = static_cast<class_id_t>(at - m_classes.begin());
        if (at == m_classes.end()) m_classes.push_back(label);
        const auto [entry, isNew] = m_classOf.try_emplace(normalized(name), id);
        if (!isNew && entry->second != id)
            throw InputError("the label map " + m_source + " gives '" + name + "' to two classes.");
    }
    if (m_classes.empty()) throw InputError("the label map " + m_source + " names no class.");
}

LabelMap LabelMap::paper9()
{
    return LabelMap(PAPER9_CSV, "paper9");
}

LabelMap LabelMap::fromFile(const std::string& file)
{
    return fromText(readTextFile(file, "label map"), file);
}

LabelMap LabelMap::fromText(const std::string& text, const std::string& source)
{
    return LabelMap(text, source);
}

bool LabelMap::isHeader(const CsvRow& row)
{
    return row.fields == HEADER;
}

class_id_t LabelMap::classOf(const std::string& name) const
{
    const auto at = m_classOf.find(normalized(name));
    return at == m_classOf.end() ? NO_CLASS : at->second;
}
}  // namespace voxeland
