// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/CategoryEvidence.h"
#include "voxeland/map/ViewingSide.h"

#include <optional>
#include <vector>

namespace voxeland
{
/** What detectors said of one instance's category, kept so that an opinion can count by what it
 * adds: of the same side of an object a network says nearly the same again, however often it is
 * asked. Memory: one CategoryEvidence for each side the object was seen from, at most SIDES. */
class CategoryOpinions
{
 public:
    /** The opinions about one side. */
    struct OfSide
    {
        side_t side = 0;
        double opinions = 0;   //!< how many; of a part of a divided instance maybe less than 1
        CategoryEvidence sum;  //!< of them
    };

    /** Adds one opinion. \param evidence its distribution times its confidence
     *  \param side it was looked at from; none: the opinion repeats no other, and counts fully */
    void add(const CategoryEvidence& evidence, std::optional<side_t> side = std::nullopt);
    /** Adds evidence that repeats no other. */
    void add(category_id_t category, double beta);
    /** Adds all of another instance's opinions. */
    void add(const CategoryOpinions& other);
    /** Takes a share of everything away. \param share in [0,1] \return what was taken */
    CategoryOpinions take(double share);

    /** All opinions, plainly summed (paper, "Semantic integration"). */
    [[nodiscard]] const CategoryEvidence& sum() const { return m_sum; }
    /** The opinions by what they add: those about one side repeat one another, and n of them are
     * worth 2 n / (n + 1) independent ones, see weightOfRepetition(). */
    [[nodiscard]] CategoryEvidence independent() const;

    /** \name For files
     * @{ */
    [[nodiscard]] const CategoryEvidence& ofNoSide() const { return m_ofNoSide; }
    /** In order of the sides. */
    [[nodiscard]] const std::vector<OfSide>& bySide() const { return m_bySide; }
    /** What was written; \throws std::invalid_argument for sides that are none or not in order, or
     * numbers of opinions that are not above 0 */
    static CategoryOpinions restored(CategoryEvidence sum, CategoryEvidence ofNoSide,
                                     std::vector<OfSide> bySide);
    /** @} */

 private:
    OfSide& at(side_t side);

    CategoryEvidence m_sum, m_ofNoSide;
    std::vector<OfSide> m_bySide;
};
}  // namespace voxeland
