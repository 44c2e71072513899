// SPDX-License-Identifier: BSD-3-Clause
#include "CocoReader.h"

#include "CocoMasks.h"
#include "ImageName.h"
#include "Tolerance.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"

#include <algorithm>
#include <cmath>

using nlohmann::json;

namespace voxeland
{
namespace
{
constexpr double LARGEST_IMAGE = 32768;  // pixels a side
constexpr double ROUNDING = 1e-5;        // by which a score may exceed 1

double numberOf(const json& value, const std::string& what)
{
    if (!value.is_number()) throw std::invalid_argument(what + " is not a number");
    return value.get<double>();
}

/** Whole numbers, also written as 3.0. */
std::optional<int64_t> wholeNumber(const json& value)
{
    constexpr double LARGEST = 9e15;
    const bool isHuge =
        value.is_number_unsigned() && value.get<uint64_t>() > static_cast<uint64_t>(INT64_MAX);
    if (!value.is_number() || isHuge) return std::nullopt;
    if (value.is_number_integer()) return value.get<int64_t>();
    const auto number = value.get<double>();
    if (std::abs(number) > LARGEST || number != std::floor(number)) return std::nullopt;
    return static_cast<int64_t>(number);
}

/** An image's id, a number or a text. */
std::optional<std::string> idOf(const json& value)
{
    if (value.is_string() && !value.get<std::string>().empty()) return value.get<std::string>();
    const auto number = wholeNumber(value);
    return number ? std::optional(std::to_string(*number)) : std::nullopt;
}

/** Pixels of an image's side; 0 if it is not said. */
int sideOf(const json& image, const char* key)
{
    if (!image.contains(key)) return 0;
    const json& value = image.at(key);
    const auto side = value.is_string()   ? parsed<double>(value.get<std::string>())
                      : value.is_number() ? std::optional(value.get<double>())
                                          : std::nullopt;
    return side && *side >= 1 && *side <= LARGEST_IMAGE ? static_cast<int>(*side) : 0;
}

/** What an object has under a key, unless that is null. */
const json* in(const json& object, const char* key)
{
    if (!object.is_object() || !object.contains(key) || object.at(key).is_null()) return nullptr;
    return &object.at(key);
}

/** Whether a prediction's image_id is a name as Ultralytics writes it. */
bool namesImage(const json& prediction)
{
    const json* id = in(prediction, "image_id");
    return id != nullptr && id->is_string() && isStem(id->get<std::string>());
}

/** Text of bytes as Python's str() shows it, b'...', as the bytes. */
std::string withoutPythonsQuotes(const std::string& text)
{
    if (text.size() < 3 || text[0] != 'b' || (text[1] != '\'' && text[1] != '"') ||
        text.back() != text[1])
        return text;
    std::string bytes;
    for (size_t i = 2; i + 1 < text.size(); ++i) {
        if (text[i] == '\\') ++i;
        bytes += text[i];
    }
    return bytes;
}

bool isPair(const json& value)
{
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/** Coordinates x0, y0, x1, y1, ... of a polygon, also given as pairs. */
std::vector<double> pointsOf(const json& polygon)
{
    std::vector<double> points;
    for (const auto& value : polygon) {
        if (isPair(value))
            for (const auto& v : value) points.push_back(v.get<double>());
        else
            points.push_back(numberOf(value, "segmentation"));
    }
    return points;
}

/** What keeps a polygon from having an area in an image; empty if nothing does. */
std::string problemOf(const std::vector<double>& polygon)
{
    constexpr double FARTHEST = 1e6;
    if (polygon.size() < 6 || polygon.size() % 2 != 0)
        return "a polygon needs three or more x, y pairs";
    if (std::any_of(polygon.begin(), polygon.end(),
                    [](double v) { return !(std::abs(v) <= FARTHEST); }))
        return "a polygon has a point that is far off";
    if (std::all_of(polygon.begin(), polygon.end(), [](double v) { return v >= 0 && v <= 1; }))
        return "a polygon is in shares of the image: pixels are expected";
    return "";
}

PixelBox boundsOf(const std::vector<std::vector<double>>& polygons)
{
    double left = LARGEST_IMAGE, top = LARGEST_IMAGE, right = 0, bottom = 0;
    for (const auto& polygon : polygons)
        for (size_t i = 0; i + 1 < polygon.size(); i += 2) {
            left = std::min(left, polygon[i]);
            right = std::max(right, polygon[i]);
            top = std::min(top, polygon[i + 1]);
            bottom = std::max(bottom, polygon[i + 1]);
        }
    return {static_cast<int32_t>(left), static_cast<int32_t>(top),
            static_cast<int32_t>(std::ceil(right - left)),
            static_cast<int32_t>(std::ceil(bottom - top))};
}

PixelBox transposed(const PixelBox& box)
{
    return {box.y, box.x, box.height, box.width};
}

/** Whether two boxes are roughly the same. */
bool fit(const PixelBox& a, const PixelBox& b)
{
    constexpr double LEAST_IOU = 0.25;
    const auto overlap = [](int32_t a0, int32_t aSize, int32_t b0, int32_t bSize) {
        return std::max(0.0,
                        static_cast<double>(std::min(a0 + aSize, b0 + bSize)) - std::max(a0, b0));
    };
    const double both = overlap(a.x, a.width, b.x, b.width) * overlap(a.y, a.height, b.y, b.height);
    const double either =
        static_cast<double>(a.width) * a.height + static_cast<double>(b.width) * b.height - both;
    return both >= LEAST_IOU * either;
}
}  // namespace

CocoReader::CocoReader(CocoPredictions& target, const CategoryNames& names)
    : m_target(target), m_givenNames(names)
{
}

void CocoReader::read(const json& root)
{
    json byImage;
    const json& list = listIn(root, byImage);
    if (const json* categories = in(root, "categories")) readCategories(*categories);
    const json* images = in(root, "images");
    if (images) readImages(*images);
    learnNumbering(list, !images && byImage.is_null());
    for (const auto& prediction : list) {
        m_image.clear();
        try {
            readPrediction(prediction);
        } catch (const OddEntry& e) {
            leaveOut(e.what());
        } catch (const std::invalid_argument& e) {
            leaveOut(e.what());
        }
        ++m_place;
    }
    if (m_target.count() == 0 && m_target.m_leftOut.count() > 0)
        throw InputError("none of " + counted(list.size(), "prediction") + " can be used, " +
                         m_target.m_leftOut.first());
    keepMostMaskSize();
    checkImageSizes();
    checkBoxes();
}

const json& CocoReader::listIn(const json& root, json& byImage) const
{
    if (root.is_array()) return root;
    if (root.is_object())
        for (const char* key : {"annotations", "predictions", "results"})
            if (root.contains(key) && root.at(key).is_array()) return root.at(key);
    const auto isList = [](const json& value) { return value.is_array(); };
    if (!root.is_object() || root.empty() || root.contains("images") ||
        !std::all_of(root.begin(), root.end(), isList))
        throw InputError(m_target.m_file +
                         " is not in the COCO results format: a list of predictions, or an object"
                         " with one named 'annotations', is expected");
    byImage = json::array();
    for (const auto& [image, predictions] : root.items())
        for (json p : predictions) {
            if (p.is_object() && !p.contains("image_id")) p["image_id"] = image;
            byImage.push_back(std::move(p));
        }
    return byImage;
}

void CocoReader::readCategories(const json& list)
{
    for (const auto& c : list) {
        const auto id = c.is_object() && c.contains("id") ? wholeNumber(c.at("id")) : std::nullopt;
        if (!id || !c.contains("name") || !c.at("name").is_string())
            throw InputError(m_target.m_file +
                             ": every category needs a number 'id' and a text 'name'");
        m_ownNames[*id] = c.at("name").get<std::string>();
    }
}

void CocoReader::readImages(const json& list)
{
    m_target.m_listsImages = true;
    for (const auto& i : list) {
        const auto id = i.is_object() && i.contains("id") ? idOf(i.at("id")) : std::nullopt;
        if (!id || (i.contains("file_name") && !i.at("file_name").is_string()))
            throw InputError(m_target.m_file +
                             ": every image needs an 'id' and a text 'file_name'");
        if (m_imageById.count(*id) > 0)
            throw InputError(m_target.m_file + ": two images have the id " + *id);
        addImage({*id, i.value("file_name", ""), sideOf(i, "width"), sideOf(i, "height"), {}});
    }
}

size_t CocoReader::addImage(CocoPredictions::Image image)
{
    const size_t position = m_target.m_images.size();
    m_imageById.emplace(image.id, position);
    if (!image.name.empty()) m_imageByName.emplace(image.name, position);
    m_target.m_images.push_back(std::move(image));
    return position;
}

/** Which numbers there are, and what the file itself says of them.
 *  \param mayNameImages image ids that are names would be the file's own way */
void CocoReader::learnNumbering(const json& list, bool mayNameImages)
{
    CategoryNumbers numbers;
    numbers.predictions = list.size();
    size_t named = 0;
    for (const auto& p : list) {
        if (!p.is_object()) continue;
        if (namesImage(p)) ++named;
        const auto id = p.contains("category_id") ? wholeNumber(p.at("category_id")) : std::nullopt;
        const bool isNamed = p.contains("category_name") && p.at("category_name").is_string();
        const bool hasScores = p.contains("class_scores") && p.at("class_scores").is_object();
        if (id && *id >= 0 && isNamed)
            m_ownNames.emplace(*id, p.at("category_name").get<std::string>());
        else if (id && *id >= 0 && !hasScores)
            ++numbers.uses[*id];
        if (hasScores)
            for (const auto& score : p.at("class_scores").items())
                if (const auto number = parsed<int64_t>(score.key())) ++numbers.uses[*number];
    }
    numbers.ofNamedImages = mayNameImages && 2 * named > list.size();
    try {
        m_numbering.emplace(m_givenNames, m_ownNames, numbers);
    } catch (const InputError& e) {
        throw InputError(m_target.m_file + ": " + e.what());
    }
    if (!m_numbering->note().empty()) m_target.m_notes.push_back(m_numbering->note());
    if (!m_numbering->doubt().empty())
        m_target.m_doubts.push_back(m_target.m_file + ": " + m_numbering->doubt());
}

void CocoReader::readPrediction(const json& prediction)
{
    if (!prediction.is_object()) throw OddEntry("it is not an object");
    const size_t image = imageOf(prediction);

    CocoPredictions::Entry entry;
    entry.place = m_place;
    auto& p = entry.prediction;
    p.categories = readCategory(prediction);
    const double score =
        prediction.contains("score") ? numberOf(prediction.at("score"), "score") : 1.0;
    if (!(score >= 0 && score <= 1 + ROUNDING))
        throw OddEntry("score " + numberText(score) + " is not in [0,1]");
    p.score = static_cast<float>(std::min(score, 1.0));
    if (const json* value = in(prediction, "track_id")) {
        const auto track = wholeNumber(*value);
        if (!track) throw OddEntry("track_id is not a whole number");
        p.track = *track;
    }
    if (!prediction.contains("segmentation"))
        throw OddEntry("there is no segmentation: boxes alone are not enough");
    readSegmentation(prediction.at("segmentation"), entry);
    if (prediction.contains("bbox")) readBox(prediction, entry);
    m_target.m_images[image].entries.push_back(std::move(entry));
}

/** Position of its image, which unless the file lists images may be a new one. */
size_t CocoReader::imageOf(const json& prediction)
{
    const bool isNamed = prediction.contains("file_name") && prediction.at("file_name").is_string();
    const std::string name = isNamed ? prediction.at("file_name").get<std::string>() : "";
    if (!prediction.contains("image_id") && name.empty()) throw OddEntry("there is no image_id");
    const auto id = prediction.contains("image_id") ? idOf(prediction.at("image_id")) : name;
    if (!id) throw OddEntry("image_id is neither a whole number nor a text");
    m_image = *id;
    if (const auto found = m_imageById.find(*id); found != m_imageById.end()) return found->second;
    if (m_target.m_listsImages) {
        const auto found = m_imageByName.find(*id);
        if (found != m_imageByName.end()) return found->second;
        throw OddEntry("its image is not in the list 'images'");
    }
    const bool idIsName = prediction.contains("image_id") && prediction.at("image_id").is_string();
    return addImage({*id, !name.empty() ? name : idIsName ? *id : "", 0, 0, {}});
}

CategoryDistribution CocoReader::readCategory(const json& prediction) const
{
    if (const json* classScores = in(prediction, "class_scores")) {
        const json& scores = *classScores;
        if (!scores.is_object())
            throw OddEntry("class_scores is not an object of scores by category");
        CategoryDistribution distribution;
        for (const auto& [key, value] : scores.items()) {
            const double score = numberOf(value, "class_scores");
            if (score < 0) throw OddEntry("class_scores has a negative one, of " + key);
            const auto number = parsed<int64_t>(key);
            distribution.push_back(
                {number ? m_numbering->nameOf(*number) : key, static_cast<float>(score)});
        }
        distribution = normalized(std::move(distribution));
        if (distribution.empty()) throw OddEntry("class_scores has no positive score");
        return distribution;
    }
    if (const json* categoryName = in(prediction, "category_name")) {
        const json& name = *categoryName;
        if (!name.is_string() || name.get<std::string>().empty())
            throw OddEntry("category_name is not a text");
        return {{name.get<std::string>(), 1.0F}};
    }
    if (!prediction.contains("category_id")) throw OddEntry("there is no category_id");
    const auto number = wholeNumber(prediction.at("category_id"));
    if (!number || *number < 0) throw OddEntry("category_id is not a whole number from 0");
    return {{m_numbering->nameOf(*number), 1.0F}};
}

void CocoReader::readSegmentation(const json& segmentation, CocoPredictions::Entry& entry)
{
    if (segmentation.is_array())
        readPolygons(segmentation, entry);
    else
        readRunLengths(segmentation, entry);
}

/** A list of polygons, or a single one. Those without an area are left out if others have one. */
void CocoReader::readPolygons(const json& segmentation, CocoPredictions::Entry& entry)
{
    if (segmentation.empty()) throw OddEntry("segmentation is empty");
    const bool isOne =
        segmentation.at(0).is_number() ||
        (segmentation.size() > 2 && std::all_of(segmentation.begin(), segmentation.end(), isPair));
    const json list = isOne ? json::array({segmentation}) : segmentation;
    std::vector<std::string> problems;
    for (const auto& polygon : list) {
        auto points = pointsOf(polygon);
        if (const auto problem = problemOf(points); !problem.empty())
            problems.push_back(problem);
        else
            entry.polygons.push_back(std::move(points));
    }
    if (entry.polygons.empty()) throw OddEntry(problems.front());
    for (const auto& problem : problems) leaveOut(problem);
}

void CocoReader::readRunLengths(const json& segmentation, CocoPredictions::Entry& entry)
{
    if (!segmentation.is_object() || !segmentation.contains("size") ||
        !segmentation.contains("counts") || !segmentation.at("size").is_array() ||
        segmentation.at("size").size() != 2)
        throw OddEntry("segmentation is neither polygons nor run lengths with 'size' and 'counts'");
    const double height = numberOf(segmentation.at("size").at(0), "size");
    const double width = numberOf(segmentation.at("size").at(1), "size");
    if (!(width >= 1 && height >= 1 && width <= LARGEST_IMAGE && height <= LARGEST_IMAGE))
        throw OddEntry("the size of the mask is not one of an image");
    const int w = static_cast<int>(width), h = static_cast<int>(height);
    const auto& counts = segmentation.at("counts");
    std::vector<uint32_t> runs;
    if (counts.is_string()) {
        runs = decodeCocoCounts(withoutPythonsQuotes(counts.get<std::string>()));
    } else {
        for (const auto& run : counts) {
            const double length = numberOf(run, "counts");
            if (!(length >= 0 && length <= width * height))
                throw OddEntry("counts do not fit the size");
            runs.push_back(static_cast<uint32_t>(length));
        }
    }
    if (runs.empty()) throw OddEntry("segmentation has no counts");
    m_alongRows = RunLengthMask(w, h, runs).boundingBox();
    entry.columns = RunLengthMask(h, w, std::move(runs));
    ++m_maskSizes[{w, h}];
}

/** An odd box is left out, not the prediction: the mask has one. */
void CocoReader::readBox(const json& prediction, CocoPredictions::Entry& entry)
{
    const auto& box = prediction.at("bbox");
    if (!box.is_array() || box.size() != 4 ||
        !std::all_of(box.begin(), box.end(), [](const json& v) { return v.is_number(); }))
    {
        leaveOut("bbox is not x, y, width, height: the mask's box is used");
        return;
    }
    const auto x = box.at(0).get<double>(), y = box.at(1).get<double>();
    const double right = x + box.at(2).get<double>(), bottom = y + box.at(3).get<double>();
    if (!(std::max({std::abs(x), std::abs(y), right, bottom}) <= LARGEST_IMAGE && right >= x &&
          bottom >= y))
    {
        leaveOut("bbox is not one of an image: the mask's box is used");
        return;
    }
    const auto left = static_cast<int32_t>(std::floor(x)),
               top = static_cast<int32_t>(std::floor(y));
    entry.prediction.box = {left, top, static_cast<int32_t>(std::ceil(right)) - left,
                            static_cast<int32_t>(std::ceil(bottom)) - top};
    const bool hasPolygons = !entry.polygons.empty();
    if (!hasPolygons && entry.columns.empty()) return;
    ++m_boxes;
    if (fit(entry.prediction.box,
            hasPolygons ? boundsOf(entry.polygons) : transposed(entry.columns.boundingBox())))
        return;
    ++m_boxesApart;
    if (!hasPolygons && fit(entry.prediction.box, m_alongRows)) ++m_boxesOfRows;
}

void CocoReader::keepMostMaskSize()
{
    const auto most =
        std::max_element(m_maskSizes.begin(), m_maskSizes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == m_maskSizes.end()) return;
    m_target.m_maskWidth = most->first.first;
    m_target.m_maskHeight = most->first.second;
}

/** Sizes that many polygons do not lie in are not those that they were drawn in. */
void CocoReader::checkImageSizes()
{
    size_t polygons = 0, outside = 0;
    for (const auto& image : m_target.m_images) {
        if (image.width == 0 || image.height == 0) continue;
        for (const auto& entry : image.entries) {
            if (entry.polygons.empty()) continue;
            const PixelBox box = boundsOf(entry.polygons);
            ++polygons;
            if (box.x + box.width / 2 >= image.width || box.y + box.height / 2 >= image.height)
                ++outside;
        }
    }
    if (isTolerable(outside, polygons)) return;
    m_target.m_doubts.push_back(m_target.m_file + ": " + counted(outside, "polygon") + " of " +
                                std::to_string(polygons) +
                                " lie outside of the width and height that its images are listed"
                                " with, which are not used: correct them");
    for (auto& image : m_target.m_images) image.width = image.height = 0;
}

/** Where most masks are not in their boxes, either is not what COCO means. */
void CocoReader::checkBoxes()
{
    if (2 * m_boxesOfRows > m_boxes)
        throw InputError(m_target.m_file +
                         ": the masks' run lengths go along the rows; COCO's go down the columns:"
                         " transpose the masks before encoding them");
    if (2 * m_boxesApart <= m_boxes) return;
    m_target.m_notes.push_back(
        "most of its bboxes are not around the masks (x, y, width, height "
        "are expected): the masks' own boxes are used");
    for (auto& image : m_target.m_images)
        for (auto& entry : image.entries) entry.prediction.box = {};
}

void CocoReader::leaveOut(const std::string& problem)
{
    m_target.m_leftOut.add(m_target.m_file + ": prediction " + std::to_string(m_place) +
                           (m_image.empty() ? "" : " (image_id " + m_image + ")") + ": " + problem);
}
}  // namespace voxeland
