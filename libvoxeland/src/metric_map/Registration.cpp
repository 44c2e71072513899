// SPDX-License-Identifier: BSD-3-Clause
/** How MRPT's programs create a CVoxelandMap from their INI, and how it is serialized. */
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <mrpt/serialization/CArchive.h>

#include <ostream>

namespace voxeland
{
MAP_DEFINITION_REGISTER("voxeland::CVoxelandMap,voxelandMap", voxeland::CVoxelandMap)

CVoxelandMap::TMapDefinition::TMapDefinition() = default;

void CVoxelandMap::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
    const std::string creation = sectionNamePrefix + "_creationOpts";
    load = source.read_string(creation, "load", "");
    const std::string file = source.read_string(creation, "config", "");
    Ini all;
    if (!file.empty())
        all = Ini::fromFile(file);
    else if (!load.empty())
        all = Ini::fromText(loadMap(load)->configText(), load);
    else
        all = Ini::fromText("", sectionNamePrefix + "_*");
    all.setFromPrefixedSections(source, sectionNamePrefix, MapperConfig::sections());
    ini = MapperConfig(all).reproducibleText();
    likelihoodOpts.loadFromConfigFile(source, sectionNamePrefix + "_likelihoodOpts");
}

void CVoxelandMap::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
    out << ini << "\n";
    likelihoodOpts.dumpToTextStream(out);
}

MapFactoryResult CVoxelandMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
    const auto& d = dynamic_cast<const CVoxelandMap::TMapDefinition&>(definition);
    const MapperConfig config(Ini::fromText(d.ini, "the map's definition"));
    auto map = std::make_unique<CVoxelandMap>();
    if (!d.load.empty()) *map = std::move(*loadMap(d.load));
    map->setConfig(config);
    map->likelihoodOptions = d.likelihoodOpts;
    return mapFactoryResult(std::move(map));
}

uint8_t CVoxelandMap::serializeGetVersion() const
{
    return FORMAT;
}

void CVoxelandMap::serializeTo(mrpt::serialization::CArchive& out) const
{
    out << m_configText << m_counts.frames << m_counts.framesWithoutPredictions
        << m_counts.framesWithoutPose << m_counts.predictionsWithoutFrame << m_counts.opinions
        << m_counts.merges << m_counts.splits;
    m_map->writeTo(out);
    m_assembler.writeTo(out);
    likelihoodOptions.writeTo(out);
    out << genericMapParams;
}

void CVoxelandMap::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
    if (version != FORMAT) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
    CVoxelandMap read;
    in >> read.m_configText >> read.m_counts.frames >> read.m_counts.framesWithoutPredictions >>
        read.m_counts.framesWithoutPose >> read.m_counts.predictionsWithoutFrame >>
        read.m_counts.opinions >> read.m_counts.merges >> read.m_counts.splits;
    read.m_map.edit().readFrom(in);
    read.m_assembler.readFrom(in);
    read.likelihoodOptions.readFrom(in);
    in >> read.genericMapParams;
    *this = std::move(read);
}
}  // namespace voxeland
