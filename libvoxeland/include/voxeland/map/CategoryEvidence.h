// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace voxeland
{
/** Number of a category name within one map, from 0 in order of appearance. */
using category_id_t = uint32_t;

/** Name given to what no category speaks for. */
inline constexpr const char* UNKNOWN_CATEGORY = "unknown";
/** Its number in every map: it is in no table, and no detector's opinion is for it. */
inline constexpr category_id_t UNKNOWN_CATEGORY_ID = 0xFFFFFFFF;

/** Category names a map has met: an open set, extended whenever a new one comes. */
class CategoryTable
{
 public:
    /** Number of a name, added if new. */
    category_id_t add(const std::string& name);
    /** Number of a name, if it has one. */
    [[nodiscard]] std::optional<category_id_t> find(const std::string& name) const;
    /** Name of a number, UNKNOWN_CATEGORY_ID included; throws std::out_of_range for one that was
     * never given. */
    [[nodiscard]] const std::string& name(category_id_t id) const;
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
    [[nodiscard]] size_t size() const { return m_names.size(); }

 private:
    std::vector<std::string> m_names;
    std::unordered_map<std::string, category_id_t> m_ids;
};

/** Concentration parameters beta_l of one instance's Dirichlet distribution over categories: the
 * sum of confidences of the opinions that named category l (paper, "Map Representation").
 * Categories without evidence are not stored; entries are ordered by id. */
class CategoryEvidence
{
 public:
    /** There is no more evidence of a category than this: sums stay finite. */
    static constexpr double MOST = 1e100;

    /** Evidence of one category. */
    struct Entry
    {
        category_id_t category = 0;
        double beta = 0;  //!< accumulated confidence, > 0
    };

    [[nodiscard]] const std::vector<Entry>& entries() const { return m_entries; }
    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    [[nodiscard]] double total() const;
    [[nodiscard]] double betaOf(category_id_t category) const;
    /** The category with most evidence (of equals the one with the lowest id), none if empty. */
    [[nodiscard]] std::optional<category_id_t> top() const;
    /** Adds evidence, up to MOST (may be negative to take some back; an entry that reaches zero
     * goes). What is not finite is no evidence: nothing changes. */
    void add(category_id_t category, double beta);
    /** Adds all of another's evidence, scaled. */
    void add(const CategoryEvidence& other, double scale = 1);

 private:
    std::vector<Entry> m_entries;
};

/** A distribution raised to a power and normalized: the greater the exponent, the more of it goes
 * to the most probable category. */
CategoryEvidence sharpened(const CategoryEvidence& distribution, double exponent);

/** Semantic similarity S_sem = 1 - JSD of the two means, in [0,1] (paper, "Data Association";
 * base-2 logarithms). 0 if either has no evidence. */
double semanticSimilarity(const CategoryEvidence& a, const CategoryEvidence& b);
}  // namespace voxeland
