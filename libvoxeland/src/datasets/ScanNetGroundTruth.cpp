// SPDX-License-Identifier: BSD-3-Clause
#include "AnnotatedObjects.h"
#include "DatasetFiles.h"
#include "PlyVertices.h"
#include "ScanNetCategories.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/GroundTruth.h"
#include "voxeland/files/Json.h"

#include <filesystem>
#include <unordered_map>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
const std::string MESH = "_vh_clean_2";

/** What an object of the aggregation is. */
struct Claim
{
    uint32_t instance = 0;
    std::string category;
};

/** The mesh of a scene's folder. */
fs::path findMesh(const fs::path& path)
{
    if (!fs::is_directory(path)) return path;
    const std::string ending = MESH + ".ply";
    for (const fs::path& entry : entriesOf(path)) {
        const std::string name = entry.filename().string();
        if (name.size() > ending.size() &&
            name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
            return entry;
    }
    throw InputError("there is no SCENE" + ending + " in " + path.string() + ".");
}

/** Segment of each vertex. */
std::vector<int64_t> readSegments(const std::string& file, size_t vertices)
{
    const auto json = readJson(file);
    std::vector<int64_t> segments;
    try {
        segments = json.at("segIndices").get<std::vector<int64_t>>();
    } catch (const nlohmann::json::exception&) {
        throw InputError(file + " has no list 'segIndices' of whole numbers.");
    }
    if (segments.size() != vertices)
        throw InputError(file + " is of another mesh: it has " + std::to_string(segments.size()) +
                         " segIndices for " + std::to_string(vertices) + " vertices.");
    return segments;
}

/** Object of each segment; of several that claim it, the last. */
std::unordered_map<int64_t, Claim> readClaims(const std::string& file,
                                              const ScanNetCategories& categories)
{
    const auto json = readJson(file);
    std::unordered_map<int64_t, Claim> claims;
    try {
        const auto segmentsFile = json.value("segmentsFile", MESH);
        if (segmentsFile.find(MESH) == std::string::npos)
            throw InputError(file + " is about the segments in " + segmentsFile +
                             ", not those of the mesh" + MESH + ": use SCENE.aggregation.json.");
        for (const auto& group : json.at("segGroups")) {
            const Claim claim = {group.at("objectId").get<uint32_t>() + 1,
                                 categories.ofRaw(group.at("label").get<std::string>())};
            for (const auto& segment : group.at("segments")) claims[segment.get<int64_t>()] = claim;
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(file +
                         " has no list 'segGroups' of objectId, label and segments as ScanNet's"
                         " files have.");
    }
    return claims;
}
}  // namespace

GroundTruth readScanNetGroundTruth(const std::string& path)
{
    const fs::path mesh = findMesh(path);
    const std::string stem = (mesh.parent_path() / mesh.stem()).string();
    const size_t ending = stem.rfind(MESH);
    if (ending == std::string::npos || ending + MESH.size() != stem.size())
        throw InputError(mesh.string() + " is not named SCENE" + MESH + ".ply.");
    const ScanNetCategories categories(mesh.parent_path());
    const auto columns = readPlyVertices(mesh.string(), {{"x"}, {"y"}, {"z"}});
    GroundTruth gt;
    gt.points = pointsOf(columns, mesh.string());
    const auto segments = readSegments(stem + ".0.010000.segs.json", gt.points.size());
    const auto claims = readClaims(stem.substr(0, ending) + ".aggregation.json", categories);

    PointAnnotator annotator(gt);
    for (const int64_t segment : segments) {
        const auto claim = claims.find(segment);
        if (claim == claims.end())
            annotator.addNone();
        else
            annotator.addObject(claim->second.instance, claim->second.category);
    }
    return gt;
}
}  // namespace voxeland
