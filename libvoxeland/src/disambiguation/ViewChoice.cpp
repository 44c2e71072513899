// SPDX-License-Identifier: BSD-3-Clause
#include "ViewChoice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

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

/** Takes the view of greatest worth, again and again. \param worth called as worth(view, chosen) */
template <typename Worth>
Views chooseGreedily(Views views, size_t most, Worth&& worth)
{
    Views chosen;
    while (chosen.size() < most && !views.empty()) {
        const auto best = std::max_element(views.begin(), views.end(),
                                           [&](const CandidateView& a, const CandidateView& b) {
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
float greatestSharpness(const Views& views)
{
    float greatest = 0;
    for (const CandidateView& v : views) greatest = std::max(greatest, v.sharpness);
    return greatest;
}
}  // namespace

Views chooseViews(Views views, size_t most, ViewSelection how, uint32_t seed)
{
    const float sharpest = greatestSharpness(views);
    const auto quality = [sharpest](const CandidateView& v) {
        return v.view.quality() * (sharpest > 0 ? v.sharpness / sharpest : 1);
    };
    std::stable_sort(views.begin(), views.end(),
                     [&](const auto& a, const auto& b) { return quality(a) > quality(b); });
    if (how == ViewSelection::random) shuffle(views, seed);
    if (how == ViewSelection::random || how == ViewSelection::largest) {
        views.resize(std::min(most, views.size()));
        return views;
    }
    if (how == ViewSelection::spread)
        return chooseGreedily(std::move(views), most, [&](const auto& v, const Views& chosen) {
            return chosen.empty() ? quality(v) : angleToNearest(v, chosen);
        });
    return chooseGreedily(std::move(views), most, [&](const auto& v, const Views& chosen) {
        return quality(v) * std::min(angleToNearest(v, chosen), FAR);
    });
}

void keepChosenViews(UncertainInstance& instance, const DisambiguationOptions& options)
{
    std::map<category_id_t, Views> fetched;
    for (CandidateView& v : instance.views)
        if (!v.picture.empty()) fetched[v.category].push_back(std::move(v));
    instance.views.clear();
    for (const RankedCategory& c : instance.candidates)
        for (CandidateView& v :
             chooseViews(std::move(fetched[c.category]), options.views_per_category,
                         options.view_selection, options.seed + instance.id))
        {
            if (!instance.views.empty()) v.wholeFrame.clear();
            instance.views.push_back(std::move(v));
        }
}
}  // namespace voxeland
