// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/CalibrationLearning.h"

#include "InstanceVerdicts.h"
#include "voxeland/base/errors.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxeland
{
namespace
{
using Samples = std::vector<CalibrationSample>;

double totalOf(const std::map<std::string, double>& words)
{
    double total = 0;
    for (const auto& [word, evidence] : words) total += evidence;
    return total;
}

/** The word for what an object is. */
std::string wordFor(const std::string& category, const std::map<std::string, double>& said,
                    const CategoryTable& words, const LabelMap& labels)
{
    if (words.find(category)) return category;
    const class_id_t cls = labels.classOf(category);
    if (cls == NO_CLASS) return UNKNOWN_CATEGORY;
    std::string best = UNKNOWN_CATEGORY;
    double most = -1;  // of the words of its class the one said most
    for (const std::string& word : words.names()) {
        const auto at = said.find(word);
        const double evidence = at == said.end() ? 0 : at->second;
        if (labels.classOf(word) == cls && evidence > most) {
            best = word;
            most = evidence;
        }
    }
    return best;
}

/** How many instances are what, by word: each counts for its words by their share of evidence. */
struct Counts
{
    std::map<std::string, std::map<std::string, double>> ofWord;
    double right = 0, unknown = 0, all = 0;

    explicit Counts(const std::vector<const Samples*>& maps)
    {
        for (const Samples* samples : maps)
            for (const CalibrationSample& s : *samples) add(s);
    }

    /** How often each category is met, one more than it was so that none is impossible. */
    [[nodiscard]] std::map<std::string, double> frequencies() const
    {
        std::map<std::string, double> result;
        for (const auto& [word, counts] : ofWord) result[word] = 1;
        for (const auto& [word, counts] : ofWord)
            for (const auto& [category, n] : counts)
                if (category != UNKNOWN_CATEGORY) result[category] += n;
        return result;
    }

 private:
    void add(const CalibrationSample& s)
    {
        const double total = totalOf(s.words);
        for (const auto& [word, evidence] : s.words) {
            const double share = evidence / total;
            ofWord[word][s.truth] += share;
            all += share;
            if (word == s.truth) right += share;
            if (s.truth == UNKNOWN_CATEGORY) unknown += share;
        }
    }
};

std::map<std::string, Calibration::Meaning> meaningsFrom(const Counts& counts)
{
    constexpr double PRIOR = 5;                           // instances
    constexpr double RIGHT_BEFORE = 2, WRONG_BEFORE = 1;  // of three imagined ones
    constexpr double UNKNOWN_BEFORE = 2, OTHER_BEFORE = 2;
    const double wrong = counts.all - counts.right;
    const double right = (counts.right + RIGHT_BEFORE) / (counts.all + RIGHT_BEFORE + WRONG_BEFORE);
    const double unknown =
        (1 - right) * (counts.unknown + UNKNOWN_BEFORE) / (wrong + UNKNOWN_BEFORE + OTHER_BEFORE);
    const auto frequencies = counts.frequencies();
    const double frequencyOfAll = totalOf(frequencies);

    std::map<std::string, Calibration::Meaning> meanings;
    for (const auto& [word, met] : counts.ofWord) {
        const double total = totalOf(met) + PRIOR;
        const double others = frequencyOfAll - frequencies.at(word);
        Calibration::Meaning& meaning = meanings[word];
        meaning[word] = PRIOR * right / total;
        meaning[UNKNOWN_CATEGORY] = PRIOR * unknown / total;
        for (const auto& [category, n] : frequencies)
            if (category != word)
                meaning[category] = PRIOR * (1 - right - unknown) * n / others / total;
        for (const auto& [category, n] : met) meaning[category] += n / total;
    }
    meanings[Calibration::ANY] = {{Calibration::ANY, right}, {UNKNOWN_CATEGORY, 1 - right}};
    for (auto& [word, meaning] : meanings) {
        const double sum = totalOf(meaning);  // 1, but for a single word that has no others
        for (auto& [category, p] : meaning) p /= sum;
    }
    return meanings;
}

/** Mean of -ln of the probability given to what the instances are. */
double lossOf(const Calibration& calibration, const Samples& samples)
{
    constexpr double LEAST = 1e-6;
    double loss = 0;
    for (const CalibrationSample& s : samples) {
        CategoryTable table;
        CategoryEvidence said;
        for (const auto& [word, evidence] : s.words) said.add(table.add(word), evidence);
        const category_id_t truth =
            s.truth == UNKNOWN_CATEGORY ? UNKNOWN_CATEGORY_ID : table.add(s.truth);
        const CategoryEvidence meant = calibration.applied(said, table);
        loss -= std::log(std::max(meant.betaOf(truth) / meant.total(), LEAST));
    }
    return loss;
}

/** Parts of the samples, each of which is left out in turn. */
std::vector<Samples> foldsOf(const std::vector<Samples>& maps)
{
    if (maps.size() > 1) return maps;
    constexpr size_t PARTS = 5;
    std::vector<Samples> folds(PARTS);
    for (size_t i = 0; i < maps.front().size(); ++i) folds[i % PARTS].push_back(maps.front()[i]);
    return folds;
}

std::vector<const Samples*> allBut(const std::vector<Samples>& folds, size_t left)
{
    std::vector<const Samples*> rest;
    for (size_t i = 0; i < folds.size(); ++i)
        if (i != left) rest.push_back(&folds[i]);
    return rest;
}
}  // namespace

std::vector<CalibrationSample> calibrationSamples(const SemanticVoxelMap& map,
                                                  const EvaluatedScene& scene,
                                                  const LabelMap& labels)
{
    std::vector<CalibrationSample> samples;
    const auto objects = objectsOfInstances(scene, EvaluationProtocol().minPoints);
    for (size_t i = 0; i < objects.size(); ++i) {
        if (!objects[i]) continue;
        CalibrationSample s;
        const CategoryEvidence said = map.instance(scene.instances[i].id).categories.independent();
        for (const auto& e : said.entries()) s.words[map.categories().name(e.category)] = e.beta;
        s.truth = wordFor(scene.objects[*objects[i]].category, s.words, map.categories(), labels);
        if (!s.words.empty()) samples.push_back(std::move(s));
    }
    return samples;
}

Calibration learnCalibration(const std::vector<std::vector<CalibrationSample>>& samples)
{
    constexpr double AGREEMENTS[] = {1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4};
    constexpr double USUAL = 2, SPREAD = 0.25;  // of a log-normal prior of the agreement
    constexpr size_t ENOUGH = 10;
    size_t instances = 0;
    for (const Samples& ofMap : samples) instances += ofMap.size();
    if (instances < ENOUGH)
        throw InputError("only " + std::to_string(instances) +
                         " instances stand for an annotated object: give more maps");
    const std::vector<Samples> folds = foldsOf(samples);
    std::vector<std::map<std::string, Calibration::Meaning>> meanings;
    for (size_t i = 0; i < folds.size(); ++i)
        meanings.push_back(meaningsFrom(Counts(allBut(folds, i))));
    const auto loss = [&](double agreement) {
        const double deviation = std::log(agreement / USUAL) / SPREAD;
        double sum = deviation * deviation / 2;
        for (size_t i = 0; i < folds.size(); ++i)
            sum += lossOf(Calibration(meanings[i], agreement), folds[i]);
        return sum;
    };
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (const double agreement : AGREEMENTS)
        if (const double l = loss(agreement); l < least) {
            least = l;
            best = agreement;
        }
    return Calibration(meaningsFrom(Counts(allBut(folds, folds.size()))), best);
}
}  // namespace voxeland
