// SPDX-License-Identifier: BSD-3-Clause
#include "ViewChoice.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voxeland
{
namespace
{
using Views = std::vector<CandidateView>;

constexpr float FAR = static_cast<float>(M_PI / 2);  // sides differ as much as they need to

/** Angle between two directions of view [rad]. */
float angleBetween(const CandidateView& a, const CandidateView& b)
{
    const auto u = a.view.direction(), v = b.view.direction();
    return std::acos(std::clamp(u.x * v.x + u.y * v.y + u.z * v.z, -1.0F, 1.0F));
}

float angleToNearest(const CandidateView& view, const Views& chosen)
{
    float least = static_cast<float>(M_PI);
    for (const CandidateView& c : chosen) least = std::min(least, angleBetween(view, c));
    return least;
}

float greatestSharpness(const Views& views)
{
    float greatest = 0;
    for (const CandidateView& v : views) greatest = std::max(greatest, v.sharpness);
    return greatest;
}
}  // namespace

Views chooseViews(Views views, size_t most)
{
    const float sharpest = greatestSharpness(views);
    const auto quality = [sharpest](const CandidateView& v) {
        return v.view.quality() * (sharpest > 0 ? v.sharpness / sharpest : 1);
    };
    std::stable_sort(views.begin(), views.end(),
                     [&](const auto& a, const auto& b) { return quality(a) > quality(b); });
    Views chosen;
    const auto worth = [&](const CandidateView& v) {
        return quality(v) * std::min(angleToNearest(v, chosen), FAR);
    };
    while (chosen.size() < most && !views.empty()) {
        const auto best = std::max_element(
            views.begin(), views.end(),
            [&](const CandidateView& a, const CandidateView& b) { return worth(a) < worth(b); });
        chosen.push_back(*best);
        views.erase(best);
    }
    return chosen;
}

void keepChosenViews(UncertainInstance& instance, const DisambiguationOptions& options)
{
    std::map<category_id_t, Views> fetched;
    for (CandidateView& v : instance.views)
        if (!v.picture.empty()) fetched[v.category].push_back(std::move(v));
    instance.views.clear();
    for (const RankedCategory& c : instance.candidates)
        for (CandidateView& v :
             chooseViews(std::move(fetched[c.category]), options.views_per_category)) {
            if (!instance.views.empty()) v.wholeFrame.clear();
            instance.views.push_back(std::move(v));
        }
}
}  // namespace voxeland
