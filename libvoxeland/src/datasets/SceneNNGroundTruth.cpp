// SPDX-License-Identifier: BSD-3-Clause
#include "AnnotatedObjects.h"
#include "DatasetFiles.h"
#include "PlyVertices.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/GroundTruth.h"
#include "voxeland/files/InputFile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tinyxml2.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** The annotated mesh of a scene's folder: the PLY file with an XML file of the same name. */
fs::path findMesh(const fs::path& path)
{
    if (!fs::is_directory(path)) return path;
    for (const fs::path& file : entriesOf(path)) {
        if (file.extension() == ".ply" && fs::exists(fs::path(file).replace_extension(".xml")))
            return file;
    }
    throw InputError("there is no NNN.ply with an NNN.xml in " + path.string() + ".");
}

std::string attribute(const tinyxml2::XMLElement& element, const char* name)
{
    const char* value = element.Attribute(name);
    return value == nullptr ? "" : value;
}

/** Category of each annotated label. */
std::map<int64_t, std::string> readCategories(const std::string& file)
{
    checkInputFile(file, "the annotation");
    tinyxml2::XMLDocument document;
    if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS)
        throw InputError(file + " is not valid XML at line " +
                         std::to_string(std::max(1, document.ErrorLineNum())) +
                         ": correct it there, or copy the annotation again");
    const auto* root = document.RootElement();
    if (root == nullptr)
        throw InputError(file + " holds no XML element: give SceneNN's annotation");
    std::map<int64_t, std::string> categories;
    bool hasClasses = false;
    for (const auto* label = root->FirstChildElement("label"); label != nullptr;
         label = label->NextSiblingElement("label"))
    {
        int64_t id = 0;
        if (label->QueryInt64Attribute("id", &id) != tinyxml2::XML_SUCCESS)
            throw InputError("line " + std::to_string(label->GetLineNum()) + " of " + file +
                             " has a label without a number 'id'.");
        hasClasses = hasClasses || label->FindAttribute("nyu_class") != nullptr;
        const std::string category = attribute(*label, "nyu_class");
        if (!category.empty() && category != "unknown" && !attribute(*label, "text").empty())
            categories[id] = category;
    }
    if (!hasClasses)
        throw InputError(file +
                         " has no label with an 'nyu_class': use the annotation in SceneNN's folder"
                         " contrib/nyu_class.");
    return categories;
}
}  // namespace

GroundTruth readSceneNNGroundTruth(const std::string& path)
{
    const fs::path mesh = findMesh(path);
    const auto categories = readCategories(fs::path(mesh).replace_extension(".xml").string());
    const auto columns =
        readPlyVertices(mesh.string(), {{"x"}, {"y"}, {"z"}, {"label", PlyNumber::integer}});
    GroundTruth gt;
    gt.points = pointsOf(columns, mesh.string());
    PointAnnotator annotator(gt);
    for (const double label : columns[3]) {
        const auto found = categories.find(static_cast<int64_t>(label));
        if (found == categories.end() || label <= 0)
            annotator.addNone();
        else
            annotator.addObject(static_cast<uint32_t>(label), found->second);
    }
    return gt;
}
}  // namespace voxeland
