// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/CategoryEvidence.h"

#include <map>
#include <string>

namespace voxeland
{
/** What a detector's words mean: for each of them how probable each category is where the detector
 * says it, *unknown* among them for what it has no word for. Learnt by voxeland-calibrate from
 * annotated maps. By default words mean themselves. */
class Calibration
{
 public:
    /** Probabilities by category, which sum to 1. */
    using Meaning = std::map<std::string, double>;
    /** As a word: any without a meaning of its own. As a category: the word itself. */
    static constexpr const char* ANY = "*";
    static constexpr double MOST_AGREEMENT = 100;

    Calibration() = default;
    /** \param meanings by word \param agreement see applied(), in [1, MOST_AGREEMENT]
     *  \throws std::invalid_argument for an agreement out of range, and for probabilities of a
     * word that are not above 0 or do not sum to 1 */
    Calibration(std::map<std::string, Meaning> meanings, double agreement);

    /** Reads the table: CSV with the header `word,category,probability`. The probabilities of a
     * word sum to 1, but for 0.01 that people round.
     *  \throws InputError, naming the file, if it is missing or malformed, or as the constructor */
    static Calibration fromCsv(const std::string& file, double agreement);
    /** The table as text. */
    [[nodiscard]] std::string csv() const;

    [[nodiscard]] bool isIdentity() const { return m_meanings.empty() && m_agreement == 1; }
    [[nodiscard]] const std::map<std::string, Meaning>& meanings() const { return m_meanings; }
    [[nodiscard]] double agreement() const { return m_agreement; }

    /** What evidence means. With q_l the mean over the words, by their share of the evidence, of
     * how probable category l is: as much evidence as there was, shared among the categories like
     * q_l to the power of agreement(). Where words agree each of them makes the others more
     * credible; a power of 1 would leave them as doubtful as any single one.
     *  \param table of the map; categories that it lacks count for *unknown* */
    [[nodiscard]] CategoryEvidence applied(const CategoryEvidence& evidence,
                                           const CategoryTable& table) const;

 private:
    [[nodiscard]] const Meaning* meaningOf(const std::string& word) const;

    std::map<std::string, Meaning> m_meanings;
    double m_agreement = 1;
};
}  // namespace voxeland
