// SPDX-License-Identifier: BSD-3-Clause
#include "OctoMapFile.h"

#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <cmath>
#include <filesystem>
#include <octomap/OcTree.h>

namespace voxeland
{
namespace
{
/** OctoMap numbers its voxels from 0; its voxel of this number starts at the origin, as our 0. */
constexpr int ORIGIN = 32768;

octomap::key_type keyOf(int64_t coordinate)
{
    if (coordinate < -ORIGIN || coordinate >= ORIGIN)
        throw ConfigurationError(
            "an OctoMap reaches 32768 voxels from the origin of the world, the map farther: use "
            "a coarser resolution, or --ply");
    return static_cast<octomap::key_type>(coordinate + ORIGIN);
}

octomap::OcTree octreeOf(const SemanticVoxelMap& map)
{
    octomap::OcTree tree(map.resolution());
    tree.setClampingThresMin(map.options().occupancy.prob_min);
    tree.setClampingThresMax(map.options().occupancy.prob_max);
    const auto shift = [&](double metres) { return std::llround(metres / map.resolution()); };
    const int64_t x = shift(map.origin().x), y = shift(map.origin().y), z = shift(map.origin().z);
    for (const uint32_t b : map.blocks().sorted()) {
        const MapBlock& block = map.blocks()[b];
        for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
            const log_odds_t occupancy = block.occupancy(cell);
            if (occupancy == UNOBSERVED) continue;
            const VoxelCoord v = voxelAt(map.blocks().coordOf(b), cell);
            const float logOdds = octomap::logodds(OccupancyFilter::probability(occupancy));
            tree.setNodeValue(octomap::OcTreeKey(keyOf(x + v.x), keyOf(y + v.y), keyOf(z + v.z)),
                              logOdds, true);
        }
    }
    tree.updateInnerOccupancy();
    tree.prune();
    return tree;
}

/** As tree.writeBinary() does, which in Debian's build also prints on the standard error. */
void writeBinary(const octomap::OcTree& tree, std::ostream& out)
{
    out << "# Octomap OcTree binary file\nid " << tree.getTreeType() << "\nsize " << tree.size()
        << "\nres " << tree.getResolution() << "\ndata\n";
    tree.writeBinaryData(out);
}
}  // namespace

void exportOctoMap(const SemanticVoxelMap& map, const std::string& file)
{
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending != ".bt" && ending != ".ot")
        throw ConfigurationError("'" + file +
                                 "' must end in .bt (free or occupied) or .ot (probabilities)");
    const octomap::OcTree tree = octreeOf(map);
    writeAtomically(file, [&](std::ostream& out) {
        if (ending == ".bt")
            writeBinary(tree, out);
        else
            tree.write(out);
    });
}

Exporter octoMapExporter()
{
    Exporter e{"octomap", "FILE.bt", "Occupancy as an OctoMap (.bt, or .ot with probabilities)"};
    e.endings = {".bt", ".ot"};
    e.write = [](const SemanticVoxelMap& map, const ExportSettings&, const std::string& file,
                 WrittenFiles& written) {
        exportOctoMap(map, file);
        written.add(file);
    };
    return e;
}
}  // namespace voxeland
