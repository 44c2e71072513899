// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/InstanceViews.h"

#include "voxeland/map/ViewingSide.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace voxeland
{
namespace
{
using Views = std::vector<InstanceView>;

bool isBetter(const InstanceView& a, const InstanceView& b)
{
    const auto key = [](const InstanceView& v) {
        const auto& [c, t] = std::pair(v.camera, v.target);
        return std::tuple(-v.quality(), v.frame, v.time, v.box.x, v.box.y, v.box.width,
                          v.box.height, -v.probability, v.area, v.truncated, c.x, c.y, c.z, t.x,
                          t.y, t.z);
    };
    return key(a) < key(b);
}

/** Sorts views by their rank within their sector, then by quality, and keeps the first ones. */
void keepBest(Views& views, size_t most)
{
    std::sort(views.begin(), views.end(), isBetter);
    std::map<int, size_t> met;
    std::vector<std::pair<size_t, size_t>> order;  // rank within the sector, place by quality
    for (size_t i = 0; i < views.size(); ++i)
        order.emplace_back(met[sectorOf(views[i].direction())]++, i);
    std::sort(order.begin(), order.end());
    Views kept;
    for (size_t i = 0; i < std::min(most, order.size()); ++i)
        kept.push_back(views[order[i].second]);
    views = std::move(kept);
}
}  // namespace

mrpt::math::TPoint3Df InstanceView::direction() const
{
    return viewingDirection(camera, target);
}

float InstanceView::quality() const
{
    const float size = std::sqrt(static_cast<float>(area));
    return size * score * probability * (truncated ? 0.5F : 1.0F);
}

bool InstanceView::isPossible() const
{
    const auto isPlace = [](const mrpt::math::TPoint3Df& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    };
    return std::isfinite(quality()) && quality() >= 0 && isPlace(camera) && isPlace(target);
}

const Views& InstanceViews::of(category_id_t category) const
{
    static const Views none;
    const auto at = m_views.find(category);
    return at == m_views.end() ? none : at->second;
}

void InstanceViews::add(category_id_t category, const InstanceView& view, uint32_t most)
{
    if (most == 0 || !view.isPossible()) return;
    Views& views = m_views[category];
    views.push_back(view);
    keepBest(views, most);
}

void InstanceViews::add(const InstanceViews& other, uint32_t most)
{
    for (const auto& [category, views] : other.m_views)
        for (const InstanceView& view : views) add(category, view, most);
}

void InstanceViews::moveTo(InstanceViews& other,
                           const std::function<bool(const InstanceView&)>& belongs, uint32_t most)
{
    for (auto& [category, views] : m_views) {
        const auto moved = std::stable_partition(
            views.begin(), views.end(), [&](const InstanceView& v) { return !belongs(v); });
        for (auto view = moved; view != views.end(); ++view) other.add(category, *view, most);
        views.erase(moved, views.end());
    }
    for (auto at = m_views.begin(); at != m_views.end();)
        at = at->second.empty() ? m_views.erase(at) : std::next(at);
}
}  // namespace voxeland
