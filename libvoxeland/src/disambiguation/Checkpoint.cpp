// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/Checkpoint.h"

#include "voxeland/disambiguation/Decisions.h"
#include "voxeland/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <cstring>
#include <filesystem>

namespace voxeland
{
namespace
{
/** Whether two maps are the same but for decisions. */
bool areAlike(SemanticVoxelMap a, SemanticVoxelMap b)
{
    mrpt::io::CMemoryStream bytes[2];
    SemanticVoxelMap* maps[2] = {&a, &b};
    for (int i = 0; i < 2; ++i) {
        undoDecisions(*maps[i], std::nullopt);
        auto archive = mrpt::serialization::archiveFrom(bytes[i]);
        maps[i]->writeTo(archive);
    }
    const size_t n = bytes[0].getTotalBytesCount();
    return n == bytes[1].getTotalBytesCount() &&
           std::memcmp(bytes[0].getRawBufferData(), bytes[1].getRawBufferData(), n) == 0;
}

size_t decisionsOf(const SemanticVoxelMap& map)
{
    size_t n = 0;
    for (const auto& [id, instance] : map.instances()) n += instance.decisions.size();
    return n;
}
}  // namespace

size_t takeOverDecisions(CVoxelandMap& map, const std::string& output)
{
    if (!std::filesystem::is_regular_file(output)) return 0;
    std::shared_ptr<CVoxelandMap> earlier;
    try {
        earlier = loadMap(output);
    } catch (const InputError&) {
        return 0;
    }
    const size_t had = decisionsOf(map.map()), has = decisionsOf(earlier->map());
    if (has <= had || !areAlike(map.map(), earlier->map())) return 0;
    map.editMap() = earlier->map();
    return has - had;
}
}  // namespace voxeland
