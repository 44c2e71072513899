// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/RgbdDatasetReader.h"

#include "voxeland/datasets/SevenScenesReader.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <map>

namespace voxeland
{
void RgbdDatasetReader::select(int64_t first, int64_t last, size_t every)
{
    if (every == 0) throw ConfigurationError("'every' must be 1 or more");
    if (first > last)
        throw ConfigurationError("the first frame, " + std::to_string(first) +
                                 ", is behind the last, " + std::to_string(last));
    m_first = first;
    m_last = last;
    m_every = every;
}

bool RgbdDatasetReader::isSelected(size_t index) const
{
    const int64_t number = m_frames[index].number;
    return number >= m_first && number <= m_last &&
           static_cast<uint64_t>(number - m_first) % m_every == 0;
}

size_t RgbdDatasetReader::selectedCount() const
{
    size_t n = 0;
    for (size_t i = 0; i < m_frames.size(); ++i) n += isSelected(i) ? 1 : 0;
    return n;
}

bool RgbdDatasetReader::next(RgbdRecord& record)
{
    for (; m_next < m_frames.size(); ++m_next) {
        if (!isSelected(m_next)) continue;
        try {
            record = read(m_next);
            m_current = m_next++;
            return true;
        } catch (const UnusableFrame& e) {
            m_skipped.push_back({m_frames[m_next], e.what()});
        }
    }
    return false;
}

namespace
{
using Factory = std::unique_ptr<RgbdDatasetReader> (*)(const std::string& folder);

template <typename Reader>
std::unique_ptr<RgbdDatasetReader> make(const std::string& folder)
{
    return std::make_unique<Reader>(folder);
}

const std::map<std::string, Factory> FORMATS = {{"7scenes", make<SevenScenesReader>}};
}  // namespace

std::vector<std::string> datasetFormats()
{
    std::vector<std::string> names;
    for (const auto& [name, factory] : FORMATS) names.push_back(name);
    return names;
}

std::unique_ptr<RgbdDatasetReader> openDataset(const std::string& format, const std::string& folder)
{
    const auto found = FORMATS.find(format);
    if (found != FORMATS.end()) return found->second(folder);
    std::string known;
    for (const auto& name : datasetFormats()) known += " " + name;
    throw ConfigurationError("format '" + format + "' is not known; there is:" + known);
}
}  // namespace voxeland
