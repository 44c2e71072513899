// SPDX-License-Identifier: BSD-3-Clause
/** How MRPT's programs create a CVoxelandMap from their INI, and how it is serialized. */
#include "WarnOnce.h"
#include "base/Reading.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/nearestWord.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"
#include "voxeland/plugins/OptionList.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <limits>
#include <ostream>

namespace voxeland
{
MAP_DEFINITION_REGISTER("voxeland::CVoxelandMap,voxelandMap", voxeland::CVoxelandMap)

namespace
{
const std::string CREATION = "creationOpts", LIKELIHOOD = "likelihoodOpts";

/** MRPT leaves alone what it does not look for: a misspelt section would count for nothing. */
void checkSections(const mrpt::config::CConfigFileBase& source, const std::string& prefix)
{
    std::vector<std::string> known = MapperConfig::sections(), all;
    known.insert(known.end(), {CREATION, LIKELIHOOD});
    source.getAllSections(all);
    for (const std::string& section : all) {
        if (section.compare(0, prefix.size(), prefix) != 0) continue;
        const std::string name = section.substr(prefix.size());
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string nearest = nearestWord(name, known);
        throw ConfigurationError(
            "a voxeland map has no section [" + section + "]" +
            (nearest.empty() ? "" : " (did you mean [" + prefix + nearest + "]?)"));
    }
}

/** What section `<prefix>_creationOpts` may say. */
struct CreationOptions
{
    std::string load, config;

    /** \param generic what MRPT has read from the same section */
    CreationOptions(const mrpt::config::CConfigFileBase& source, const std::string& prefix,
                    mrpt::maps::TMapGenericParams generic)
    {
        OptionList list;
        list.add("load", load, "Map to begin with");
        list.add("config", config, "INI of Voxeland");
        const std::string mrpts = "See mrpt::maps::TMapGenericParams";
        list.add("enableSaveAs3DObject", generic.enableSaveAs3DObject, mrpts);
        list.add("enableObservationLikelihood", generic.enableObservationLikelihood, mrpts);
        list.add("enableObservationInsertion", generic.enableObservationInsertion, mrpts);
        Ini ini;
        ini.setFromPrefixedSections(source, prefix, {CREATION});
        std::vector<std::string> problems;
        list.load(ini, CREATION, problems);
        if (!problems.empty()) throw ConfigurationError(joined(problems, "; "));
    }
};
}  // namespace

CVoxelandMap::TMapDefinition::TMapDefinition() = default;

void CVoxelandMap::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
    const std::string prefix = sectionNamePrefix + "_";
    checkSections(source, prefix);
    const CreationOptions creation(source, sectionNamePrefix, genericMapParams);
    load = creation.load;
    Ini all = Ini::fromText("", prefix + "*");
    if (!load.empty()) {
        const auto loaded = loadMap(load);
        all = Ini::fromMap(loaded->configText(), load);
        likelihoodOpts = loaded->likelihoodOptions;
    }
    if (!creation.config.empty()) all = Ini::fromFile(creation.config);
    all.setFromPrefixedSections(source, sectionNamePrefix, MapperConfig::sections());
    config = std::make_shared<MapperConfig>(all, MapperConfig::Purpose::mapping, warnOnce);
    likelihoodOpts.loadFromConfigFile(source, prefix + LIKELIHOOD);
    if (likelihoodOpts.max_corr_distance > DistanceField::LARGEST_REACH * config->map.resolution)
        throw ConfigurationError("[" + prefix + LIKELIHOOD +
                                 "] max_corr_distance is more than 99 voxels: look less far");
}

void CVoxelandMap::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
    out << "load = " << load << "\n" << (config ? config->text() : "") << "\n";
    likelihoodOpts.dumpToTextStream(out);
}

MapFactoryResult CVoxelandMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
    const auto& d = dynamic_cast<const CVoxelandMap::TMapDefinition&>(definition);
    auto map = std::make_unique<CVoxelandMap>();
    if (!d.load.empty()) *map = std::move(*loadMap(d.load));
    map->setConfig(d.config ? *d.config : MapperConfig());
    map->likelihoodOptions = d.likelihoodOpts;
    return mapFactoryResult(std::move(map));
}

namespace
{
constexpr size_t MOST_FRAMES = std::numeric_limits<uint32_t>::max();

std::optional<std::string> readCamera(mrpt::serialization::CArchive& in)
{
    const bool isKnown = readTruth(in);
    const std::string label = readText(in);
    return isKnown ? std::optional(label) : std::nullopt;
}
}  // namespace

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
    out << genericMapParams << m_camera.has_value() << m_camera.value_or("");
    const std::vector<uint64_t> frames = m_frames.sorted();
    out << static_cast<uint32_t>(frames.size());
    for (const uint64_t frame : frames) out << frame;
}

void CVoxelandMap::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
    if (version < OLDEST_FORMAT || version > FORMAT)
        MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
    CVoxelandMap read;
    read.m_configText = readText(in);
    in >> read.m_counts.frames >> read.m_counts.framesWithoutPredictions >>
        read.m_counts.framesWithoutPose >> read.m_counts.predictionsWithoutFrame >>
        read.m_counts.opinions >> read.m_counts.merges >> read.m_counts.splits;
    read.m_map.edit().readFrom(in);
    read.m_assembler.readFrom(in);
    read.likelihoodOptions.readFrom(in);
    in >> read.genericMapParams;
    if (version > 2) read.m_camera = readCamera(in);
    if (version > 4)
        read.m_frames = MappedFrames::restored(readValues<std::vector<uint64_t>>(in, MOST_FRAMES));
    *this = std::move(read);
}
}  // namespace voxeland
