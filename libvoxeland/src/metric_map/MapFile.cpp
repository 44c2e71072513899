// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/MapFile.h"

#include "files/GzInputFile.h"
#include "files/GzOutputFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/CVoxelandMap.h"

namespace voxeland
{
namespace
{
/** MRPT keeps what a map says of its version to itself, but the version is behind the class's name.
 *  \param bytes of the object as far as it was read */
void checkFormat(const std::string& bytes, const std::string& file)
{
    const std::string name = CVoxelandMap::GetRuntimeClassIdStatic().className;
    const size_t at = 1 + name.size();
    if (bytes.size() <= at || bytes.compare(1, name.size(), name) != 0) return;
    const auto format = static_cast<uint8_t>(bytes[at]);
    if (format >= CVoxelandMap::OLDEST_FORMAT && format <= CVoxelandMap::FORMAT) return;
    throw InputError("'" + file + "' is a map of another version of Voxeland (format " +
                     std::to_string(format) + ", this one reads " +
                     std::to_string(CVoxelandMap::OLDEST_FORMAT) + " to " +
                     std::to_string(CVoxelandMap::FORMAT) + "): map its rawlog again");
}

mrpt::serialization::CSerializable::Ptr readObject(GzInputFile& in, const std::string& file)
{
    try {
        return in.readObject();
    } catch (const InputError&) {
        checkFormat(in.objectBytes(), file);
        throw;
    }
}
}  // namespace

std::shared_ptr<CVoxelandMap> loadMap(const std::string& file)
{
    GzInputFile in(file);
    const auto map = std::dynamic_pointer_cast<CVoxelandMap>(readObject(in, file));
    if (!map) throw InputError("'" + file + "' is not a voxeland map");
    // Reading to the end verifies gzip's checksum.
    if (in.readObject()) throw InputError("'" + file + "' holds more than a voxeland map");
    return map;
}

void saveMap(const CVoxelandMap& map, const std::string& file)
{
    writeAtomically(file, map);
}
}  // namespace voxeland
