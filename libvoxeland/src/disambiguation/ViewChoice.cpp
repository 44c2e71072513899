// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/ViewChoice.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace voxeland
{
namespace
{
using Views = std::vector<InstanceView>;

constexpr float FAR = static_cast<float>(M_PI / 2);  // sides differ as much as they need to

/** Angle between two directions of view [rad]. */
float angleBetween(const InstanceView& a, const InstanceView& b)
{
    const auto u = a.direction(), v = b.direction();
    return std::acos(std::clamp(u.x * v.x + u.y * v.y + u.z * v.z, -1.0F, 1.0F));
}

float angleToNearest(const InstanceView& view, const Views& chosen)
{
    float least = static_cast<float>(M_PI);
    for (const InstanceView& c : chosen) least = std::min(least, angleBetween(view, c));
    return least;
}

/** Takes the view of greatest worth, again and again. \param worth called as worth(view, chosen) */
template <typename Worth>
Views chooseGreedily(Views views, size_t most, Worth&& worth)
{
    Views chosen;
    while (chosen.size() < most && !views.empty()) {
        const auto best = std::max_element(views.begin(), views.end(),
                                           [&](const InstanceView& a, const InstanceView& b) {
                                               return worth(a, chosen) < worth(b, chosen);
                                           });
        chosen.push_back(*best);
        views.erase(best);
    }
    return chosen;
}

/** As std::shuffle(), but the same everywhere. */
void shuffle(Views& views, uint32_t seed)
{
    std::mt19937 random(seed);
    for (size_t n = views.size(); n > 1; --n) std::swap(views[n - 1], views[random() % n]);
}
}  // namespace

Views chooseViews(Views views, size_t most, ViewSelection how, uint32_t seed)
{
    std::stable_sort(views.begin(), views.end(),
                     [](const auto& a, const auto& b) { return a.quality() > b.quality(); });
    if (how == ViewSelection::random) shuffle(views, seed);
    if (how == ViewSelection::random || how == ViewSelection::largest) {
        views.resize(std::min(most, views.size()));
        return views;
    }
    if (how == ViewSelection::spread)
        return chooseGreedily(std::move(views), most, [](const auto& v, const Views& chosen) {
            return chosen.empty() ? v.quality() : angleToNearest(v, chosen);
        });
    return chooseGreedily(std::move(views), most, [](const auto& v, const Views& chosen) {
        return v.quality() * std::min(angleToNearest(v, chosen), FAR);
    });
}
}  // namespace voxeland
