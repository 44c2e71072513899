// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/files/WrittenFiles.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace voxeland
{
/** What all outputs of a map have in common. */
struct ExportSettings
{
    GravityAlignedFrame frame;                 //!< where up is, and heights are measured
    std::optional<HeightRange> heights;        //!< above the floor [m]; none: the exporter's own
    std::set<std::string> categories, except;  //!< of points, see PointsFilter
    bool occupiedOnly = true;  //!< without voxels measured once that are now believed free
    /** Told what is worth knowing, and what is probably not as the user meant it. */
    std::function<void(const std::string&)> note = [](const std::string&) {}, warn = note;
};

/** A format that maps are written in: an option of voxeland-export, and maybe a file among those of
 * exportAll(). */
struct Exporter
{
    std::string name;         //!< of the option, without dashes
    std::string value;        //!< what stands for its value in help: FILE, or DIR for a folder
    std::string description;  //!< for help
    /** What its files are named like. A name that ends like those of another exporter is refused.
     */
    std::vector<std::string> endings = {};
    /** Its name in the folder of exportAll(); "" is that folder itself; none: it is not there. */
    std::optional<std::string> nameInAll = std::nullopt;
    bool takesHeights = false, takesCategories = false;  //!< whether these settings matter
    /** The file it writes beside one of this name, if it does. \throws ConfigurationError for a
     * name that cannot be */
    std::string (*beside)(const std::string& output) = nullptr;
    /** Writes the map. \param written those completed are added to it
     *  \throws ConfigurationError for what the format cannot hold, OutputError if writing fails */
    void (*write)(const SemanticVoxelMap& map, const ExportSettings& settings,
                  const std::string& output, WrittenFiles& written) = nullptr;

    [[nodiscard]] bool writesFolder() const { return value == "DIR"; }
};

/** All of them. A new one is a file beside the others, and a line in Exporter.cpp. */
const std::vector<Exporter>& exporters();

/** Whether a name is one for this exporter's output.
 *  \throws ConfigurationError, naming the option, if it ends like another format's files */
void checkEnding(const Exporter& exporter, const std::string& output);

/** The heights that were asked for, or else these, in the gravity-aligned frame instead of above
 * the floor [m]. Notes where they are. */
HeightRange heightsInFrame(const SemanticVoxelMap& map, const ExportSettings& settings,
                           const HeightRange& otherwise);
}  // namespace voxeland
