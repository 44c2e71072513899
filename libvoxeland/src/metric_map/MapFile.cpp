// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/MapFile.h"

#include "voxeland/errors.h"
#include "voxeland/io/AtomicFile.h"
#include "voxeland/io/GzInputFile.h"
#include "voxeland/io/GzOutputFile.h"
#include "voxeland/metric_map/CVoxelandMap.h"

namespace voxeland
{
std::shared_ptr<CVoxelandMap> loadMap(const std::string& file)
{
    GzInputFile in(file);
    const auto map = std::dynamic_pointer_cast<CVoxelandMap>(in.readObject());
    if (!map) throw InputError("'" + file + "' is not a voxeland map");
    // Reading to the end verifies gzip's checksum.
    if (in.readObject()) throw InputError("'" + file + "' holds more than a voxeland map");
    return map;
}

void saveMap(const CVoxelandMap& map, const std::string& file)
{
    AtomicFile target(file);
    GzOutputFile out(target.part());
    out.writeObject(map);
    out.close();
    target.commit();
}
}  // namespace voxeland
