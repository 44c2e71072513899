// SPDX-License-Identifier: BSD-3-Clause
#include "MatchedPredictions.h"

#include "CocoMasks.h"
#include "Tolerance.h"
#include "base/sizeText.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"

#include <cmath>
#include <set>

namespace voxeland
{
namespace
{
std::vector<PredictedImage> describe(const std::vector<CocoPredictions::Image>& images)
{
    std::vector<PredictedImage> result;
    for (const auto& i : images)
        result.push_back({i.id, i.name, parsed<int64_t>(i.id), i.entries.size()});
    return result;
}

ImageMatching matchingOf(const CocoPredictions& predictions,
                         const std::vector<DatasetFrame>& frames)
{
    try {
        return matchImages(describe(predictions.images()), predictions.listsImages(), frames);
    } catch (const InputError& e) {
        throw InputError(predictions.file() + ": " + e.what());
    }
}

/** A prediction of polygons, scaled as its box is, in an image of this size. */
InstancePrediction drawn(const CocoPredictions::Entry& entry, double scaleX, double scaleY,
                         int width, int height)
{
    auto polygons = entry.polygons;
    for (auto& polygon : polygons)
        for (size_t i = 0; i < polygon.size(); ++i) polygon[i] *= i % 2 == 0 ? scaleX : scaleY;
    InstancePrediction p = entry.prediction;
    p.mask = maskFromPolygons(width, height, polygons);
    const double left = std::floor(p.box.x * scaleX), top = std::floor(p.box.y * scaleY);
    const double right = std::ceil((p.box.x + p.box.width) * scaleX);
    const double bottom = std::ceil((p.box.y + p.box.height) * scaleY);
    p.box = {static_cast<int32_t>(left), static_cast<int32_t>(top),
             static_cast<int32_t>(right - left), static_cast<int32_t>(bottom - top)};
    return p;
}

std::string sentence(const std::string& file, const CocoPredictions::Image& image,
                     const CocoPredictions::Entry& entry, const std::string& problem)
{
    return file + ": prediction " + std::to_string(entry.place) + " (image_id " + image.id +
           "): " + problem;
}
}  // namespace

MatchedPredictions::MatchedPredictions(const CocoPredictions& predictions,
                                       const std::vector<DatasetFrame>& frames)
    : m_predictions(predictions),
      m_matching(matchingOf(predictions, frames)),
      m_leftOut(predictions.leftOut())
{
    checkWithoutFrame();
}

void MatchedPredictions::checkWithoutFrame()
{
    std::set<size_t> matched;
    for (const auto& image : m_matching.imageOf)
        if (image) matched.insert(*image);
    const auto& images = m_predictions.images();
    size_t count = 0;
    std::string first;
    for (size_t i = 0; i < images.size(); ++i) {
        if (matched.count(i) > 0 || images[i].entries.empty()) continue;
        if (count == 0) first = images[i].id;
        count += images[i].entries.size();
    }
    if (count == 0) return;
    const size_t all = m_predictions.count();
    m_withoutFrame = m_predictions.file() + ": " + std::to_string(count) + " of " +
                     counted(all, "prediction") + " have no frame, the first of image_id " + first +
                     "; images are matched " + m_matching.how +
                     (m_matching.doubt.empty() ? "" : ", but " + m_matching.doubt);
    if (m_predictions.isStrict() || !isTolerable(count, all))
        throw InputError(
            m_withoutFrame +
            (m_leftOut.count() == 0 ? "" : "; " + m_leftOut.told("odd entry", "odd entries")));
}

size_t MatchedPredictions::countFor(size_t position) const
{
    const auto image = m_matching.imageOf.at(position);
    return image ? m_predictions.images()[*image].entries.size() : 0;
}

CObservationInstances::Ptr MatchedPredictions::instancesFor(size_t position, int width, int height)
{
    const auto at = m_matching.imageOf.at(position);
    if (!at && m_predictions.listsImages()) return nullptr;
    auto result = CObservationInstances::Create();
    result->imageWidth = width;
    result->imageHeight = height;
    if (!at) return result;
    const auto& image = m_predictions.images()[*at];
    for (const auto& entry : image.entries) {
        if (!fits(image, entry, width, height)) {
            m_leftOut.add(sentence(m_predictions.file(), image, entry,
                                   "the mask is of " +
                                       sizeText(entry.columns.height(), entry.columns.width()) +
                                       " pixels, the image of " + sizeText(width, height)));
            continue;
        }
        InstancePrediction p = entry.prediction;
        if (entry.polygons.empty()) {
            p.mask = maskFromColumnRuns(width, height, entry.columns.runs());
        } else {
            const Scale scale = scaleOf(image, width, height);
            p = drawn(entry, scale.x, scale.y, width, height);
        }
        if (p.mask.empty() && !entry.polygons.empty()) {
            m_leftOut.add(sentence(m_predictions.file(), image, entry,
                                   "no pixel of the image is in its polygons"));
        } else {
            if (p.box.width == 0 || p.box.height == 0) p.box = p.mask.boundingBox();
            result->instances.push_back(std::move(p));
        }
    }
    return result;
}

bool MatchedPredictions::fits(const CocoPredictions::Image& image,
                              const CocoPredictions::Entry& entry, int width, int height) const
{
    const int w = entry.columns.height(), h = entry.columns.width();
    if (!entry.polygons.empty() || (w == width && h == height)) return true;
    if (w == m_predictions.maskWidth() && h == m_predictions.maskHeight())
        throw InputError(m_predictions.file() + ": the masks of image_id " + image.id + " are of " +
                         sizeText(w, h) + " pixels but the image has " + sizeText(width, height) +
                         (w == height && h == width ? ": size is height, width" : ""));
    return false;
}

MatchedPredictions::Scale MatchedPredictions::scaleOf(const CocoPredictions::Image& image,
                                                      int width, int height)
{
    const int w = image.width, h = image.height;
    if (w == 0 || h == 0 || (w == width && h == height)) return {};
    if (w == height && h == width)
        throw InputError(m_predictions.file() + ": image_id " + image.id + " is listed with " +
                         sizeText(w, h) + " pixels but the image has " + sizeText(width, height) +
                         ": turn its polygons, or correct its width and height");
    const Scale scale{static_cast<double>(width) / w, static_cast<double>(height) / h};
    constexpr double ROUNDING = 0.02;
    if (m_scaled.empty())
        m_scaled =
            "polygons drawn on images of other sizes are scaled to the frames', the first from " +
            sizeText(w, h) + " to " + sizeText(width, height) + " pixels" +
            (std::abs(scale.x / scale.y - 1) > ROUNDING
                 ? ", which is right if those images were stretched, not cut or padded"
                 : "");
    return scale;
}

std::vector<std::string> MatchedPredictions::notes() const
{
    auto all = m_predictions.notes();
    if (!m_scaled.empty()) all.push_back(m_scaled);
    all.push_back("images of " + m_predictions.file() + " are matched to frames " + m_matching.how);
    return all;
}

std::vector<std::string> MatchedPredictions::warnings() const
{
    std::vector<std::string> all = m_predictions.doubts();
    if (m_predictions.count() == 0) all.push_back(m_predictions.file() + " has no predictions");
    if (!m_withoutFrame.empty())
        all.push_back(m_withoutFrame);
    else if (!m_matching.doubt.empty())
        all.push_back(m_predictions.file() + ": images are matched " + m_matching.how + ", but " +
                      m_matching.doubt);
    if (m_leftOut.count() > 0) all.push_back(m_leftOut.told("odd entry", "odd entries"));
    return all;
}
}  // namespace voxeland
