// SPDX-License-Identifier: BSD-3-Clause
#include "InstancesCsv.h"

#include "files/Csv.h"
#include "voxeland/base/numbers.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/level/OrientedBox.h"
#include "voxeland/map/MapQueries.h"

namespace voxeland
{
namespace
{
constexpr const char* HEADER =
    "id,category,probability,entropy,vacuity,geometric_entropy,observations,voxels,"
    "centroid_x,centroid_y,centroid_z,min_x,min_y,min_z,max_x,max_y,max_z,"
    "box_x,box_y,box_z,box_length,box_width,box_height,box_yaw";
}  // namespace

void exportCsv(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
               const std::string& file)
{
    const auto boxes = orientedBoxes(map, frame);
    writeAtomically(file, [&](std::ostream& out) {
        out << HEADER << "\n";
        for (const InstanceSummary& s : summarizeInstances(map)) {
            const OrientedBox& box = boxes.at(s.id);
            out << s.id << "," << csvField(s.category()) << "," << s.probability() << ","
                << s.entropy << "," << s.vacuity << "," << s.geometricEntropy << ","
                << s.observations << "," << s.voxels;
            for (const auto* p : {&s.centroid, &s.boxMin, &s.boxMax, &box.center, &box.size})
                for (const double x : {p->x, p->y, p->z}) out << "," << metresText(x);
            out << "," << box.yaw << "\n";
        }
    });
}

Exporter csvExporter()
{
    Exporter e{"csv", "FILE", "Table of the instances"};
    e.endings = {".csv"};
    e.nameInAll = "instances.csv";
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        exportCsv(map, settings.frame, file);
        written.add(file);
    };
    return e;
}
}  // namespace voxeland
