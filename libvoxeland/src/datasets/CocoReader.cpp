// SPDX-License-Identifier: BSD-3-Clause
#include "CocoReader.h"

#include "voxeland/datasets/CocoMasks.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

using nlohmann::json;

namespace voxeland
{
namespace
{
constexpr double LARGEST_IMAGE = 32768;  // pixels a side

bool isNumberText(const std::string& text)
{
    return !text.empty() && text.size() < 16 &&
           text.find_first_not_of("0123456789") == std::string::npos;
}
}  // namespace

CocoReader::CocoReader(CocoPredictions& target, const CategoryNames& names)
    : m_target(target), m_givenNames(names)
{
}

void CocoReader::read(const json& root)
{
    const bool isList = root.is_array();
    if (!isList && !(root.is_object() && root.contains("annotations")))
        throw InputError(m_target.m_file +
                         " is not in the COCO results format: a list of predictions, or an object"
                         " with one named 'annotations', is expected");
    if (root.contains("categories")) readCategories(root.at("categories"));
    if (root.contains("images")) readImages(root.at("images"));
    for (const auto& prediction : isList ? root : root.at("annotations")) {
        readPrediction(prediction);
        ++m_index;
    }
}

void CocoReader::readCategories(const json& list)
{
    for (const auto& c : list) {
        if (!c.is_object() || !c.contains("id") || !c.at("id").is_number_integer() ||
            !c.contains("name") || !c.at("name").is_string())
            throw InputError(m_target.m_file +
                             ": every category needs a number 'id' and a text 'name'");
        m_ownNames[c.at("id").get<int64_t>()] = c.at("name").get<std::string>();
    }
}

void CocoReader::readImages(const json& list)
{
    m_target.m_listsImages = true;
    std::map<std::string, std::vector<int64_t>> byBareName;
    for (const auto& i : list) {
        if (!i.is_object() || !i.contains("id") || !i.at("id").is_number_integer() ||
            !i.contains("file_name") || !i.at("file_name").is_string())
            throw InputError(m_target.m_file +
                             ": every image needs a number 'id' and a text 'file_name'");
        const auto id = i.at("id").get<int64_t>();
        const std::filesystem::path path = i.at("file_name").get<std::string>();
        m_target.m_imageByPath[path.lexically_normal().string()] = id;
        byBareName[path.filename().string()].push_back(id);
    }
    for (const auto& [name, ids] : byBareName)
        if (ids.size() == 1) m_target.m_imageByPath.emplace(name, ids.front());
}

void CocoReader::readPrediction(const json& prediction)
{
    m_image.clear();
    if (!prediction.is_object()) fail("not an object");
    const int64_t image = integer(prediction, "image_id");
    m_image = std::to_string(image);

    CocoPredictions::Entry entry;
    auto& p = entry.prediction;
    p.categories = readCategory(prediction);
    const double score =
        prediction.contains("score") ? number(prediction.at("score"), "score") : 1.0;
    if (!(score >= 0 && score <= 1)) fail("score " + std::to_string(score) + " is not in [0,1]");
    p.score = static_cast<float>(score);
    if (prediction.contains("track_id")) p.track = integer(prediction, "track_id");
    if (!prediction.contains("segmentation")) fail("there is no segmentation");
    readSegmentation(prediction.at("segmentation"), entry);
    if (prediction.contains("bbox")) p.box = readBox(prediction.at("bbox"));
    m_target.m_entries[image].push_back(std::move(entry));
}

CategoryDistribution CocoReader::readCategory(const json& prediction) const
{
    if (prediction.contains("class_scores")) {
        const auto& scores = prediction.at("class_scores");
        if (!scores.is_object()) fail("class_scores is not an object of scores by category");
        CategoryDistribution distribution;
        for (const auto& [key, value] : scores.items()) {
            const double score = number(value, "class_scores");
            if (score < 0) fail("class_scores has a negative one, of " + key);
            distribution.push_back(
                {isNumberText(key) ? nameOf(std::stoll(key)) : key, static_cast<float>(score)});
        }
        distribution = normalized(std::move(distribution));
        if (distribution.empty()) fail("class_scores has no positive score");
        return distribution;
    }
    if (!prediction.contains("category_name"))
        return {{nameOf(integer(prediction, "category_id")), 1.0F}};
    const auto& name = prediction.at("category_name");
    if (!name.is_string() || name.get<std::string>().empty()) fail("category_name is not a text");
    return {{name.get<std::string>(), 1.0F}};
}

void CocoReader::readSegmentation(const json& segmentation, CocoPredictions::Entry& entry) const
{
    if (segmentation.is_array()) {
        if (segmentation.empty()) fail("segmentation is empty");
        for (const auto& polygon : segmentation) {
            auto& points = entry.polygons.emplace_back();
            for (const auto& value : polygon) points.push_back(number(value, "segmentation"));
        }
        return;
    }
    if (!segmentation.is_object() || !segmentation.contains("size") ||
        !segmentation.contains("counts") || !segmentation.at("size").is_array() ||
        segmentation.at("size").size() != 2)
        fail("segmentation is neither polygons nor run lengths with 'size' and 'counts'");
    const double height = number(segmentation.at("size").at(0), "size");
    const double width = number(segmentation.at("size").at(1), "size");
    if (!(width >= 1 && height >= 1 && width <= LARGEST_IMAGE && height <= LARGEST_IMAGE))
        fail("the size of the mask is not one of an image");
    const auto& counts = segmentation.at("counts");
    std::vector<uint32_t> runs;
    try {
        if (counts.is_string()) {
            runs = decodeCocoCounts(counts.get<std::string>());
        } else {
            for (const auto& run : counts) {
                const double length = number(run, "counts");
                if (!(length >= 0 && length <= width * height)) fail("counts do not fit the size");
                runs.push_back(static_cast<uint32_t>(length));
            }
        }
        entry.prediction.mask =
            maskFromColumnRuns(static_cast<int>(width), static_cast<int>(height), runs);
    } catch (const std::invalid_argument& e) {
        fail(e.what());
    }
}

PixelBox CocoReader::readBox(const json& box) const
{
    if (!box.is_array() || box.size() != 4) fail("bbox is not x, y, width, height");
    const double x = number(box.at(0), "bbox"), y = number(box.at(1), "bbox");
    const double right = x + number(box.at(2), "bbox"), bottom = y + number(box.at(3), "bbox");
    if (std::max({std::abs(x), std::abs(y), right, bottom}) > LARGEST_IMAGE || right < x ||
        bottom < y)
        fail("bbox is not one of an image");
    const auto left = static_cast<int32_t>(std::floor(x)),
               top = static_cast<int32_t>(std::floor(y));
    return {left, top, static_cast<int32_t>(std::ceil(right)) - left,
            static_cast<int32_t>(std::ceil(bottom)) - top};
}

double CocoReader::number(const json& value, const char* what) const
{
    if (!value.is_number()) fail(std::string(what) + " is not a number");
    return value.get<double>();
}

int64_t CocoReader::integer(const json& object, const char* key) const
{
    if (!object.contains(key)) fail("there is no " + std::string(key));
    if (!object.at(key).is_number_integer()) fail(std::string(key) + " is not a whole number");
    return object.at(key).get<int64_t>();
}

std::string CocoReader::nameOf(int64_t category) const
{
    for (const auto* names : {&m_givenNames, &std::as_const(m_ownNames), &cocoCategoryNames()}) {
        const auto found = names->find(category);
        if (found != names->end()) return found->second;
    }
    fail("category_id " + std::to_string(category) +
         " has no name: give the names with --categories");
}

void CocoReader::fail(const std::string& what) const
{
    throw InputError(m_target.m_file + ": prediction " + std::to_string(m_index) +
                     (m_image.empty() ? "" : " (image_id " + m_image + ")") + ": " + what);
}
}  // namespace voxeland
