// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/CategoryOpinions.h"

#include "evidence/Repetition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace voxeland
{
namespace
{
/** Takes a share of some evidence away. \return what was taken */
CategoryEvidence taken(CategoryEvidence& from, double share)
{
    CategoryEvidence part;
    part.add(from, share);
    from.add(part, -1);
    return part;
}
}  // namespace

CategoryOpinions::OfSide& CategoryOpinions::at(side_t side)
{
    const auto at =
        std::lower_bound(m_bySide.begin(), m_bySide.end(), side,
                         [](const OfSide& s, side_t wanted) { return s.side < wanted; });
    if (at != m_bySide.end() && at->side == side) return *at;
    return *m_bySide.insert(at, {side, 0, {}});
}

void CategoryOpinions::add(const CategoryEvidence& evidence, std::optional<side_t> side)
{
    m_sum.add(evidence);
    if (!side) {
        m_ofNoSide.add(evidence);
        return;
    }
    OfSide& s = at(*side);
    s.opinions += 1;
    s.sum.add(evidence);
}

void CategoryOpinions::add(category_id_t category, double beta)
{
    m_sum.add(category, beta);
    m_ofNoSide.add(category, beta);
}

void CategoryOpinions::add(const CategoryOpinions& other)
{
    m_sum.add(other.m_sum);
    m_ofNoSide.add(other.m_ofNoSide);
    for (const OfSide& s : other.m_bySide) {
        OfSide& own = at(s.side);
        own.opinions += s.opinions;
        own.sum.add(s.sum);
    }
}

CategoryOpinions CategoryOpinions::take(double share)
{
    CategoryOpinions part;
    part.m_sum = taken(m_sum, share);
    part.m_ofNoSide = taken(m_ofNoSide, share);
    for (OfSide& s : m_bySide) {
        part.m_bySide.push_back({s.side, share * s.opinions, taken(s.sum, share)});
        s.opinions -= part.m_bySide.back().opinions;
    }
    const auto forgetNone = [](std::vector<OfSide>& sides) {
        const auto isNone = [](const OfSide& s) { return !(s.opinions > 0); };
        sides.erase(std::remove_if(sides.begin(), sides.end(), isNone), sides.end());
    };
    forgetNone(m_bySide);
    forgetNone(part.m_bySide);
    return part;
}

CategoryEvidence CategoryOpinions::independent() const
{
    CategoryEvidence evidence = m_ofNoSide;
    for (const OfSide& s : m_bySide) evidence.add(s.sum, weightOfRepetition(s.opinions));
    return evidence;
}

CategoryOpinions CategoryOpinions::restored(CategoryEvidence sum, CategoryEvidence ofNoSide,
                                            std::vector<OfSide> bySide)
{
    for (size_t i = 0; i < bySide.size(); ++i) {
        const bool isNext = i == 0 || bySide[i - 1].side < bySide[i].side;
        const double n = bySide[i].opinions;
        if (!isNext || bySide[i].side >= SIDES || !(n > 0) || !std::isfinite(n))
            throw std::invalid_argument("opinions of no side, or of a side twice");
    }
    CategoryOpinions opinions;
    opinions.m_sum = std::move(sum);
    opinions.m_ofNoSide = std::move(ofNoSide);
    opinions.m_bySide = std::move(bySide);
    return opinions;
}
}  // namespace voxeland
