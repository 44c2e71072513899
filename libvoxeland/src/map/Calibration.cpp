// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/Calibration.h"

#include "files/Csv.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace voxeland
{
namespace
{
const std::vector<std::string> HEADER = {"word", "category", "probability"};

/** \return the sum, of which the meaning of a word is shares
 *  \throws std::invalid_argument unless all are above 0 and sum to 1, or nearly so */
double checkedSum(const std::string& word, const Calibration::Meaning& meaning, double tolerance)
{
    double sum = 0;
    for (const auto& [category, p] : meaning) {
        if (!(p > 0)) throw std::invalid_argument("a probability of '" + word + "' is not above 0");
        sum += p;
    }
    if (!(std::abs(sum - 1) <= tolerance))
        throw std::invalid_argument("the probabilities of '" + word + "' sum to " +
                                    numberText(sum) + " instead of 1");
    return sum;
}
}  // namespace

Calibration::Calibration(std::map<std::string, Meaning> meanings, double agreement)
    : m_meanings(std::move(meanings)), m_agreement(agreement)
{
    if (!(agreement >= 1 && agreement <= MOST_AGREEMENT))
        throw std::invalid_argument("the agreement is not within 1 and 100");
    for (const auto& [word, meaning] : m_meanings) checkedSum(word, meaning, 1e-9);
}

Calibration Calibration::fromCsv(const std::string& file, double agreement)
{
    const std::string source = "the calibration " + file;
    std::map<std::string, Meaning> meanings;
    for (const CsvRow& row : parseCsv(readTextFile(file, "calibration"), HEADER, source)) {
        const auto p = parsed<double>(row.fields[2]);
        const bool isNew = p && meanings[row.fields[0]].emplace(row.fields[1], *p).second;
        if (!isNew)
            throw InputError(source + ", line " + std::to_string(row.line) +
                             (p ? ": a category stands twice" : ": the probability is no number"));
    }
    try {
        for (auto& [word, meaning] : meanings) {
            const double sum = checkedSum(word, meaning, 0.01 + 1e-9);  // people round
            for (auto& [category, p] : meaning) p /= sum;
        }
        return Calibration(std::move(meanings), agreement);
    } catch (const std::invalid_argument& e) {
        throw InputError(source + ": " + e.what());
    }
}

std::string Calibration::csv() const
{
    constexpr double LEAST = 1e-6;  // of six decimals
    std::string text = "word,category,probability\n";
    for (const auto& [word, meaning] : m_meanings)
        for (const auto& [category, p] : meaning)
            text += csvField(word) + "," + csvField(category) + "," +
                    fixedText(std::max(p, LEAST), 6) + "\n";
    return text;
}

const Calibration::Meaning* Calibration::meaningOf(const std::string& word) const
{
    auto at = m_meanings.find(word);
    if (at == m_meanings.end()) at = m_meanings.find(ANY);
    return at == m_meanings.end() ? nullptr : &at->second;
}

CategoryEvidence Calibration::applied(const CategoryEvidence& evidence,
                                      const CategoryTable& table) const
{
    if (isIdentity() || evidence.empty()) return evidence;
    CategoryEvidence mean;
    for (const auto& e : evidence.entries()) {
        const Meaning* meaning = meaningOf(table.name(e.category));
        if (meaning == nullptr)
            mean.add(e.category, e.beta);
        else
            for (const auto& [category, p] : *meaning)
                mean.add(category == ANY ? e.category
                                         : table.find(category).value_or(UNKNOWN_CATEGORY_ID),
                         p * e.beta);
    }
    CategoryEvidence meant;
    meant.add(sharpened(mean, m_agreement), evidence.total());
    return meant;
}
}  // namespace voxeland
