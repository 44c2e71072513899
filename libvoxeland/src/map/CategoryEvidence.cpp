// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/CategoryEvidence.h"

#include "evidence/JensenShannon.h"

#include <algorithm>
#include <cmath>

namespace voxeland
{
category_id_t CategoryTable::add(const std::string& name)
{
    const auto [at, isNew] = m_ids.emplace(name, static_cast<category_id_t>(m_names.size()));
    if (isNew) m_names.push_back(name);
    return at->second;
}

std::optional<category_id_t> CategoryTable::find(const std::string& name) const
{
    const auto at = m_ids.find(name);
    return at == m_ids.end() ? std::nullopt : std::optional(at->second);
}

const std::string& CategoryTable::name(category_id_t id) const
{
    static const std::string unknown = UNKNOWN_CATEGORY;
    return id == UNKNOWN_CATEGORY_ID ? unknown : m_names.at(id);
}

double CategoryEvidence::total() const
{
    double sum = 0;
    for (const Entry& e : m_entries) sum += e.beta;
    return sum;
}

double CategoryEvidence::betaOf(category_id_t category) const
{
    for (const Entry& e : m_entries)
        if (e.category == category) return e.beta;
    return 0;
}

std::optional<category_id_t> CategoryEvidence::top() const
{
    const auto most =
        std::max_element(m_entries.begin(), m_entries.end(),
                         [](const Entry& a, const Entry& b) { return a.beta < b.beta; });
    if (most == m_entries.end()) return std::nullopt;
    return most->category;
}

void CategoryEvidence::add(category_id_t category, double beta)
{
    if (!std::isfinite(beta)) return;
    const auto at =
        std::lower_bound(m_entries.begin(), m_entries.end(), category,
                         [](const Entry& e, category_id_t id) { return e.category < id; });
    const bool known = at != m_entries.end() && at->category == category;
    if (!known) {
        if (beta > 0) m_entries.insert(at, {category, std::min(beta, MOST)});
        return;
    }
    at->beta = std::min(at->beta + beta, MOST);
    if (!(at->beta > 0)) m_entries.erase(at);
}

void CategoryEvidence::add(const CategoryEvidence& other, double scale)
{
    for (const Entry& e : other.m_entries) add(e.category, scale * e.beta);
}

CategoryEvidence sharpened(const CategoryEvidence& distribution, double exponent)
{
    double most = 0, sum = 0;
    for (const auto& e : distribution.entries()) most = std::max(most, e.beta);
    const auto power = [&](const CategoryEvidence::Entry& e) {
        return std::pow(e.beta / most, exponent);  // of the greatest 1, so that not all underflow
    };
    for (const auto& e : distribution.entries()) sum += power(e);
    CategoryEvidence result;
    for (const auto& e : distribution.entries()) result.add(e.category, power(e) / sum);
    return result;
}

double semanticSimilarity(const CategoryEvidence& a, const CategoryEvidence& b)
{
    if (a.empty() || b.empty()) return 0;
    std::vector<double> p, q;
    const double totalA = a.total(), totalB = b.total();
    auto i = a.entries().begin(), j = b.entries().begin();
    while (i != a.entries().end() || j != b.entries().end()) {
        const bool takeA =
            j == b.entries().end() || (i != a.entries().end() && i->category <= j->category);
        const bool takeB =
            i == a.entries().end() || (j != b.entries().end() && j->category <= i->category);
        p.push_back(takeA ? (i++)->beta / totalA : 0);
        q.push_back(takeB ? (j++)->beta / totalB : 0);
    }
    return 1 - jensenShannonDivergence(p, q);
}
}  // namespace voxeland
