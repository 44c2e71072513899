// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/GroundTruth.h"

#include "PlyVertices.h"
#include "files/Csv.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/numbers.h"

#include <filesystem>
#include <limits>
#include <map>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
using Reader = GroundTruth (*)(const std::string& path);

/** Every format with its reader. */
const std::map<std::string, Reader>& readers()
{
    static const std::map<std::string, Reader> all = {{"ply", &readPlyGroundTruth},
                                                      {"scannet", &readScanNetGroundTruth},
                                                      {"scenenn", &readSceneNNGroundTruth}};
    return all;
}

/** Category number in the file -> position in `names`. */
std::map<int64_t, uint32_t> readCategories(const fs::path& file, std::vector<std::string>& names)
{
    std::map<int64_t, uint32_t> positions;
    const std::string text = readTextFile(file.string(), "table of category names");
    for (const CsvRow& row : parseCsv(text, {"index", "name"}, file.string())) {
        const std::string& number = row.fields[0];
        const auto index = parsed<int64_t>(number);
        if (!index)
            throw InputError("'" + number + "' in " + file.string() + " is not a category number.");
        if (!positions.emplace(*index, static_cast<uint32_t>(names.size())).second)
            throw InputError(file.string() + " names category " + number + " twice.");
        names.push_back(row.fields[1]);
    }
    return positions;
}

/** An integer of a vertex; PLY columns come as doubles, which hold 32 bits exactly. */
uint32_t instanceOf(double value, const std::string& file)
{
    if (value > std::numeric_limits<uint32_t>::max())
        throw InputError("an instance number in " + file + " needs more than 32 bits.");
    return value > 0 ? static_cast<uint32_t>(value) : 0;
}
}  // namespace

GroundTruth readPlyGroundTruth(const std::string& path)
{
    fs::path file = path;
    if (fs::is_directory(file)) file /= "ground_truth.ply";
    const std::string name = file.string();
    const auto columns = readPlyVertices(name, {{"x", PlyNumber::any},
                                                {"y", PlyNumber::any},
                                                {"z", PlyNumber::any},
                                                {"instance", PlyNumber::integer},
                                                {"category", PlyNumber::integer}});
    GroundTruth gt;
    const auto positions = readCategories(file.parent_path() / "categories.csv", gt.names);
    const size_t n = columns[0].size();
    gt.points = pointsOf(columns, name);
    gt.instance.reserve(n);
    gt.category.reserve(n);
    for (size_t i = 0; i < n; ++i) {
        gt.instance.push_back(instanceOf(columns[3][i], name));
        const auto at = positions.find(static_cast<int64_t>(columns[4][i]));
        if (gt.instance.back() != 0 && at == positions.end())
            throw InputError("vertex " + std::to_string(i) + " of " + name + " is of category " +
                             std::to_string(static_cast<int64_t>(columns[4][i])) +
                             ", which categories.csv does not name.");
        gt.category.push_back(at == positions.end() ? 0 : at->second);
    }
    return gt;
}

std::vector<std::string> groundTruthFormats()
{
    std::vector<std::string> names;
    for (const auto& r : readers()) names.push_back(r.first);
    return names;
}

GroundTruth readGroundTruth(const std::string& path, const std::string& format)
{
    const auto at = readers().find(format);
    if (at == readers().end()) {
        throw ConfigurationError("no ground truth format '" + format + "', only " +
                                 joined(groundTruthFormats(), ", ") + ".");
    }
    return at->second(path);
}
}  // namespace voxeland
