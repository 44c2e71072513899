// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/CocoPredictions.h"

#include "CocoReader.h"
#include "JsonFile.h"
#include "voxeland/datasets/CocoMasks.h"
#include "voxeland/datasets/RgbdDatasetReader.h"
#include "voxeland/errors.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
std::string sizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}
}  // namespace

CocoPredictions::CocoPredictions(const std::string& file, const CategoryNames& names) : m_file(file)
{
    CocoReader(*this, names).read(readJson(file));
}

size_t CocoPredictions::count() const
{
    size_t n = 0;
    for (const auto& [image, entries] : m_entries) n += entries.size();
    return n;
}

std::optional<int64_t> CocoPredictions::imageOf(const DatasetFrame& frame) const
{
    if (!m_listsImages || frame.image.empty()) return frame.number;
    const fs::path path(frame.image);
    for (const auto& name : {path.lexically_normal().string(), path.filename().string()}) {
        const auto found = m_imageByPath.find(name);
        if (found != m_imageByPath.end()) return found->second;
    }
    return std::nullopt;
}

size_t CocoPredictions::countFor(const DatasetFrame& frame) const
{
    const auto image = imageOf(frame);
    const auto found = image ? m_entries.find(*image) : m_entries.end();
    return found == m_entries.end() ? 0 : found->second.size();
}

CObservationInstances::Ptr CocoPredictions::instancesFor(const DatasetFrame& frame, int width,
                                                         int height) const
{
    const auto image = imageOf(frame);
    if (!image) return nullptr;
    auto result = CObservationInstances::Create();
    result->imageWidth = width;
    result->imageHeight = height;
    const auto found = m_entries.find(*image);
    if (found == m_entries.end()) return result;

    for (const auto& entry : found->second) {
        InstancePrediction p = entry.prediction;
        try {
            if (!entry.polygons.empty()) p.mask = maskFromPolygons(width, height, entry.polygons);
        } catch (const std::invalid_argument& e) {
            throw InputError(m_file + ": image_id " + std::to_string(*image) + ": " + e.what());
        }
        if (p.mask.width() != width || p.mask.height() != height)
            throw InputError(m_file + ": the masks of image_id " + std::to_string(*image) +
                             " are of " + sizeText(p.mask.width(), p.mask.height()) +
                             " pixels but the image has " + sizeText(width, height));
        if (p.box.width == 0 || p.box.height == 0) p.box = p.mask.boundingBox();
        result->instances.push_back(std::move(p));
    }
    return result;
}
}  // namespace voxeland
