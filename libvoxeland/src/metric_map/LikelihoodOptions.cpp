// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/LikelihoodOptions.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/plugins/Ini.h"
#include "voxeland/plugins/OptionList.h"

#include <mrpt/serialization/CArchive.h>

#include <sstream>

namespace voxeland
{
namespace
{
const std::string SECTION = "likelihoodOpts";

void declare(OptionList& list, LikelihoodOptions& o)
{
    list.add("sigma_dist", o.sigma_dist, {0.001, 10},
             "Standard deviation of a measured point's distance to the nearest occupied voxel [m]");
    list.add("max_corr_distance", o.max_corr_distance, {0.001, 10},
             "Largest distance that tells something [m]");
    list.add("outliers", o.outliers, {1e-6, 0.999999},
             "Share of measured points that come from nothing in the map");
    list.add("max_points", o.max_points, {0, 1e9},
             "Points used of an observation, spread evenly over it; 0: all");
    list.add("independent_points", o.independent_points, {0, 1e9},
             "The points of an observation tell no more than so many independent ones; 0: all do");
    list.add("max_range", o.max_range, {0, 1e6},
             "Points farther from the sensor are left out [m]; 0: none");
}

std::string textOf(LikelihoodOptions options)
{
    OptionList list;
    declare(list, options);
    std::ostringstream text;
    list.print(text, SECTION);
    return text.str();
}
}  // namespace

void LikelihoodOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                           const std::string& section)
{
    Ini ini;
    std::vector<std::string> keys;
    if (source.sectionExists(section)) source.getAllKeys(section, keys);
    for (const std::string& key : keys)
        ini.set(SECTION + "." + key + "=" + source.read_string(section, key, ""));
    OptionList list;
    declare(list, *this);
    std::vector<std::string> problems;
    list.load(ini, SECTION, problems);
    if (!problems.empty()) throw ConfigurationError(joined(problems, "; "));
}

void LikelihoodOptions::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                         const std::string& section) const
{
    const Ini ini = Ini::fromText(textOf(*this), "the likelihood's options");
    for (const std::string& key : ini.keys(SECTION))
        target.write(section, key, ini.value(SECTION, key));
}

void LikelihoodOptions::dumpToTextStream(std::ostream& out) const
{
    out << textOf(*this);
}

void LikelihoodOptions::writeTo(mrpt::serialization::CArchive& out) const
{
    out << sigma_dist << max_corr_distance << outliers << max_points << independent_points
        << max_range;
}

void LikelihoodOptions::readFrom(mrpt::serialization::CArchive& in)
{
    in >> sigma_dist >> max_corr_distance >> outliers >> max_points >> independent_points >>
        max_range;
}
}  // namespace voxeland
