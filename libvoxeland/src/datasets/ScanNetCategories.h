// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace voxeland
{
/** ScanNet's table of labels, `scannetv2-labels.combined.tsv`: what its raw categories are among
 *  the 40 classes of NYU. A raw category without such a class keeps its name. Blanks around names
 * do not count. */
class ScanNetCategories
{
 public:
    /** Looks for the table in a scene's folder and the two above it.
     *  \throws InputError if it is not there, or malformed */
    explicit ScanNetCategories(const std::filesystem::path& sceneFolder);

    /** NYU40 class of a raw category, as in `.aggregation.json`. */
    [[nodiscard]] std::string ofRaw(const std::string& category) const;
    /** NYU40 class of a number, as in label images; empty if there is none of that number. */
    [[nodiscard]] std::string ofNumber(uint32_t id) const;

 private:
    std::map<std::string, std::string> m_ofRaw;
    std::map<uint32_t, std::string> m_ofNumber;
};
}  // namespace voxeland
