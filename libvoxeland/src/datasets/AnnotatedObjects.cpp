// SPDX-License-Identifier: BSD-3-Clause
#include "AnnotatedObjects.h"

#include <set>

namespace voxeland
{
bool isStructure(const std::string& category)
{
    return category == "wall" || category == "floor" || category == "ceiling";
}

void PointAnnotator::addObject(uint32_t instance, const std::string& category)
{
    if (isStructure(category)) return addNone();
    const auto next = static_cast<uint32_t>(m_truth.names.size());
    const auto [at, isNew] = m_positions.try_emplace(category, next);
    if (isNew) m_truth.names.push_back(category);
    m_truth.instance.push_back(instance);
    m_truth.category.push_back(at->second);
}

void PointAnnotator::addNone()
{
    m_truth.instance.push_back(0);
    m_truth.category.push_back(0);
}

CObservationInstances::Ptr predictionsOf(
    const std::vector<uint32_t>& objects, int width, int height,
    const std::function<std::string(uint32_t object)>& categoryOf)
{
    auto result = CObservationInstances::Create();
    result->imageWidth = width;
    result->imageHeight = height;
    std::vector<uint8_t> mask(objects.size());
    for (const uint32_t object : std::set<uint32_t>(objects.begin(), objects.end())) {
        const std::string category = object == 0 ? "" : categoryOf(object);
        if (category.empty() || isStructure(category)) continue;
        for (size_t i = 0; i < objects.size(); ++i) mask[i] = objects[i] == object ? 1 : 0;
        InstancePrediction p;
        p.mask = RunLengthMask::fromBitmap(mask.data(), width, height);
        p.box = p.mask.boundingBox();
        p.categories = {{category, 1}};
        p.score = 1;
        p.track = object;
        result->instances.push_back(std::move(p));
    }
    return result;
}
}  // namespace voxeland
