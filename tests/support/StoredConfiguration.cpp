// SPDX-License-Identifier: BSD-3-Clause
#include "support/StoredConfiguration.h"

#include "files/GzInputFile.h"
#include "files/GzOutputFile.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <stdexcept>

namespace voxeland::test
{
std::string contentOfMap(const std::string& file)
{
    constexpr size_t PORTION = 1 << 16;
    GzInputFile in(file);
    std::string content;
    for (size_t read = PORTION; read == PORTION;) {
        content.resize(content.size() + PORTION);
        read = in.Read(&content[content.size() - PORTION], PORTION);
        content.resize(content.size() - PORTION + read);
    }
    return content;
}

void forgeConfiguration(const std::string& file, const std::string& text)
{
    const std::string before = loadMap(file)->configText();
    std::string content = contentOfMap(file), forged = text + "\n#";
    const size_t at = content.find(before);
    if (before.empty() || at == std::string::npos || forged.size() > before.size())
        throw std::runtime_error("the map holds no configuration to forge");
    forged.resize(before.size(), ' ');
    content.replace(at, before.size(), forged);
    GzOutputFile out(file);
    out.Write(content.data(), content.size());
    out.close();
}
}  // namespace voxeland::test
