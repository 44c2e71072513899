// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuilder.h"
#include "evaluation/AveragePrecision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace voxeland;
using voxeland::test::SceneBuilder;
using Scenes = std::vector<EvaluatedScene>;

namespace
{
RankedMatches ranked(const std::vector<std::pair<double, bool>>& entries, size_t objects)
{
    RankedMatches m;
    m.objects = m.missed = objects;
    for (const auto& [score, correct] : entries) {
        m.entries.push_back({score, correct});
        if (correct) --m.missed;
    }
    return m;
}

EvaluationProtocol strictVoid()
{
    EvaluationProtocol p;
    p.voidPolicy = VoidPolicy::falsePositive;
    return p;
}
}  // namespace

// The check values of ScanNet's rule, worked out by hand from its convolution.

TEST(ScannetArea, onePerfectInstanceIsOne)
{
    EXPECT_DOUBLE_EQ(scannetArea(ranked({{0.9, true}}, 1)), 1);
}

TEST(ScannetArea, oneOfTwoObjectsFoundIsOneHalf)
{
    EXPECT_DOUBLE_EQ(scannetArea(ranked({{0.9, true}}, 2)), 0.5);
}

TEST(ScannetArea, falsePositiveOfEqualScoreGivesThreeQuarters)
{
    EXPECT_DOUBLE_EQ(scannetArea(ranked({{0.9, true}, {0.9, false}}, 1)), 0.75);
}

TEST(ScannetArea, falsePositiveOfLowerScoreCostsNothing)
{
    EXPECT_DOUBLE_EQ(scannetArea(ranked({{0.9, true}, {0.5, false}}, 1)), 1);
}

TEST(ScannetArea, falsePositiveOfHigherScore)
{
    // from the lowest score: (1/2, 1), (0, 0), (1, 0): widths (1 - 0)/2, (1 - 0)/2, 0
    EXPECT_DOUBLE_EQ(scannetArea(ranked({{0.5, true}, {0.9, false}}, 1)), 0.25);
}

TEST(ScannetArea, nothingFoundIsZeroAndNoObjectsIsNotANumber)
{
    EXPECT_EQ(scannetArea(ranked({}, 3)), 0);
    EXPECT_EQ(scannetArea(ranked({{0.9, false}}, 3)), 0);
    EXPECT_TRUE(std::isnan(scannetArea(ranked({{0.9, false}}, 0))));
}

TEST(VocArea, equalsTheMeanOverObjectsOfTheBestPrecisionAtThatRecall)
{
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const size_t objects = 1 + random() % 8;
        std::vector<std::pair<double, bool>> entries;
        size_t found = 0;
        for (size_t i = 0, n = random() % 20; i < n; ++i) {
            const bool correct = found < objects && random() % 2 == 0;
            found += correct ? 1 : 0;
            entries.emplace_back(static_cast<double>(random() % 6) / 5, correct);
        }
        double expected = 0;
        for (size_t k = 1; k <= objects; ++k) {  // recall k/objects
            double best = 0;
            for (const auto& [threshold, ignored] : entries) {
                double tp = 0, all = 0;
                for (const auto& [score, correct] : entries)
                    if (score >= threshold) {
                        ++all;
                        tp += correct ? 1 : 0;
                    }
                if (tp >= static_cast<double>(k)) best = std::max(best, tp / all);
            }
            expected += best / static_cast<double>(objects);
        }
        EXPECT_NEAR(vocArea(ranked(entries, objects)), expected, 1e-12);
    }
}

TEST(MatchClass, thresholdIsStrict)
{
    // 300 of 400 points in common: IoU 0.75 exactly
    const Scenes s = SceneBuilder().object(0, 400).instance(0, 300, 0.9).overlap(0, 0, 300);
    EXPECT_EQ(matchClass(s, 0, 0.75, {}).missed, 1U);
    EXPECT_EQ(matchClass(s, 0, 0.74, {}).missed, 0U);
    // above 0.50 ... 0.70, so five of the nine thresholds
    EXPECT_NEAR(averagePrecision(s, 0, {}).ap, 5.0 / 9, 1e-12);
    EXPECT_EQ(averagePrecision(s, 0, {}).ap50, 1);
}

TEST(MatchClass, iouOfThreeFifthsIsNotAboveSixtyPercent)
{
    const Scenes s = SceneBuilder().object(0, 500).instance(0, 300, 0.9).overlap(0, 0, 300);
    EXPECT_NEAR(averagePrecision(s, 0, {}).ap, 2.0 / 9, 1e-12);
}

TEST(MatchClass, smallInstancesAreLeftOut)
{
    const Scenes s = SceneBuilder().object(0, 100).instance(0, 99, 0.9).overlap(0, 0, 99);
    EXPECT_EQ(matchClass(s, 0, 0.5, {}).missed, 1U);
    EvaluationProtocol any;
    any.minPoints = 0;
    EXPECT_EQ(matchClass(s, 0, 0.5, any).missed, 0U);
}

TEST(MatchClass, smallObjectsAreIgnoredTogetherWithWhatMatchesThem)
{
    const Scenes s = SceneBuilder().object(0, 99).instance(0, 100, 0.9).overlap(0, 0, 99);
    for (const EvaluationProtocol& p : {EvaluationProtocol(), strictVoid()}) {
        const RankedMatches m = matchClass(s, 0, 0.5, p);
        EXPECT_EQ(m.objects, 0U);
        EXPECT_TRUE(m.entries.empty());
    }
}

TEST(MatchClass, duplicatesAreFalsePositivesWithTheLowerScore)
{
    const Scenes s = SceneBuilder()
                         .object(0, 200)
                         .instance(0, 200, 0.3)
                         .instance(0, 180, 0.8)
                         .overlap(0, 0, 200)
                         .overlap(0, 1, 180);
    const RankedMatches m = matchClass(s, 0, 0.5, {});
    ASSERT_EQ(m.entries.size(), 2U);
    EXPECT_TRUE(m.entries[0].correct);
    EXPECT_EQ(m.entries[0].score, 0.8);
    EXPECT_FALSE(m.entries[1].correct);
    EXPECT_EQ(m.entries[1].score, 0.3);
}

TEST(MatchClass, instancesOnVoidAreIgnoredUnlessVoidIsWrong)
{
    const Scenes s = SceneBuilder()
                         .object(0, 200)
                         .object(NO_CLASS, 300)
                         .instance(0, 250, 0.9)
                         .overlap(1, 0, 200);  // 200 on no evaluated class, 50 on nothing
    EXPECT_TRUE(matchClass(s, 0, 0.5, {}).entries.empty());
    EXPECT_EQ(matchClass(s, 0, 0.5, strictVoid()).entries.size(), 1U);
}

TEST(MatchClass, ignoredShareMustExceedTheThreshold)
{
    // half on void, half on an object of another class that is evaluated
    const Scenes s = SceneBuilder().object(1, 400).instance(0, 200, 0.9).overlap(0, 0, 100);
    EXPECT_EQ(matchClass(s, 0, 0.5, {}).entries.size(), 1U);
    EXPECT_TRUE(matchClass(s, 0, 0.25, {}).entries.empty());
}

TEST(MatchClass, objectsOfAnotherClassDoNotExcuse)
{
    const Scenes s = SceneBuilder().object(1, 400).instance(0, 200, 0.9).overlap(0, 0, 200);
    EXPECT_EQ(matchClass(s, 0, 0.5, {}).entries.size(), 1U);
    EXPECT_EQ(matchClass({classAgnostic(s[0])}, 0, 0.4, {}).missed, 0U);
}

TEST(MatchClass, scenesArePooled)
{
    const EvaluatedScene found =
        SceneBuilder().object(0, 200).instance(0, 200, 0.9).overlap(0, 0, 200);
    const EvaluatedScene missed = SceneBuilder().object(0, 200);
    EXPECT_EQ(averagePrecision({found, missed}, 0, {}).ap50, 0.5);
}

namespace
{
/** ScanNet's benchmark on labelled vertices and masks, after the text of its rules; slow. */
class Reference
{
 public:
    std::vector<int> truth;               //!< class * 1000 + instance of each vertex, 0: void
    std::vector<std::set<size_t>> masks;  //!< vertices of each prediction
    std::vector<int> classes;             //!< of each prediction, 1 or 2
    std::vector<double> scores;
    size_t minPoints = 0;

    double ap(int cls, double threshold) const
    {
        std::map<int, std::set<size_t>> objects;
        for (size_t v = 0; v < truth.size(); ++v)
            if (truth[v] / 1000 == cls) objects[truth[v]].insert(v);
        std::vector<std::pair<double, int>> outcomes;
        std::set<size_t> visited;
        int hardNegatives = 0, present = 0;
        for (const auto& [id, vertices] : objects) {
            if (vertices.size() < minPoints) continue;
            ++present;
            double best = -1;
            for (size_t p = 0; p < masks.size(); ++p) {
                if (!valid(p, cls) || visited.count(p) || overlap(p, vertices) <= threshold)
                    continue;
                if (best < 0) {
                    best = scores[p];
                    visited.insert(p);
                } else {
                    outcomes.emplace_back(std::min(best, scores[p]), 0);
                    best = std::max(best, scores[p]);
                }
            }
            if (best < 0)
                ++hardNegatives;
            else
                outcomes.emplace_back(best, 1);
        }
        for (size_t p = 0; p < masks.size(); ++p)
            if (valid(p, cls) && isFalse(p, cls, threshold, objects))
                outcomes.emplace_back(scores[p], 0);
        if (present == 0) return NAN;
        return area(outcomes, hardNegatives);
    }

 private:
    bool valid(size_t p, int cls) const
    {
        return classes[p] == cls && !masks[p].empty() && masks[p].size() >= minPoints;
    }
    double overlap(size_t p, const std::set<size_t>& vertices) const
    {
        double both = 0;
        for (const size_t v : masks[p]) both += vertices.count(v) ? 1 : 0;
        return both / (static_cast<double>(masks[p].size() + vertices.size()) - both);
    }
    bool isFalse(size_t p, int cls, double threshold,
                 const std::map<int, std::set<size_t>>& objects) const
    {
        double ignored = 0;
        for (const size_t v : masks[p]) ignored += truth[v] == 0 ? 1 : 0;
        for (const auto& [id, vertices] : objects) {
            if (overlap(p, vertices) > threshold) return false;
            if (id / 1000 == cls && vertices.size() < minPoints)
                for (const size_t v : masks[p]) ignored += vertices.count(v) ? 1 : 0;
        }
        return ignored / static_cast<double>(masks[p].size()) <= threshold;
    }
    static double area(const std::vector<std::pair<double, int>>& outcomes, int hardNegatives)
    {
        std::set<double> thresholds;
        for (const auto& [score, correct] : outcomes) thresholds.insert(score);
        std::vector<double> precision, recall;
        for (const double s : thresholds) {
            double tp = 0, fp = 0, fn = hardNegatives;
            for (const auto& [score, correct] : outcomes)
                if (score >= s)
                    (correct ? tp : fp) += 1;
                else if (correct)
                    fn += 1;
            precision.push_back(tp / (tp + fp));
            recall.push_back(tp / (tp + fn));
        }
        if (precision.empty()) return 0;
        precision.push_back(1);
        recall.push_back(0);
        std::vector<double> padded = recall;
        padded.insert(padded.begin(), recall.front());
        padded.push_back(0);
        double sum = 0;
        for (size_t i = 0; i < precision.size(); ++i)
            sum += precision[i] * (-0.5 * padded[i + 2] + 0.5 * padded[i]);
        return sum;
    }
};

/** The same as counts. */
Scenes countsOf(const Reference& r)
{
    EvaluatedScene scene;
    std::map<int, std::set<size_t>> objects;
    for (size_t v = 0; v < r.truth.size(); ++v)
        if (r.truth[v] != 0) objects[r.truth[v]].insert(v);
    for (size_t p = 0; p < r.masks.size(); ++p) {
        PredictedInstance i;
        i.cls = r.classes[p];
        i.points = r.masks[p].size();
        i.score = r.scores[p];
        scene.instances.push_back(i);
    }
    for (const auto& [id, vertices] : objects) {
        TrueObject o;
        o.cls = id / 1000;
        o.points = vertices.size();
        for (size_t p = 0; p < r.masks.size(); ++p) {
            size_t both = 0;
            for (const size_t v : r.masks[p]) both += vertices.count(v);
            if (both > 0) scene.overlaps.push_back({scene.objects.size(), p, both});
        }
        scene.objects.push_back(o);
    }
    return {scene};
}

Reference randomScene(std::mt19937& random)
{
    Reference r;
    r.minPoints = random() % 2 ? 4 : 0;
    for (int v = 0; v < 60; ++v) {
        const int cls = static_cast<int>(random() % 3), instance = (v / 10) % 3 + 1;
        r.truth.push_back(random() % 5 ? (v / 20) * 1000 + (v >= 20 ? instance : 0)
                                       : cls * 1000 + (cls > 0 ? instance : 0));
    }
    for (size_t p = 0, n = random() % 8; p < n; ++p) {
        std::set<size_t> mask;  // a stretch of vertices with holes; masks may overlap
        const size_t first = random() % 55, length = 1 + random() % 15;
        for (size_t v = first; v < std::min<size_t>(60, first + length); ++v)
            if (random() % 6) mask.insert(v);
        r.masks.push_back(mask);
        r.classes.push_back(1 + static_cast<int>(random() % 2));
        r.scores.push_back(static_cast<double>(random() % 4) / 4);
    }
    return r;
}
}  // namespace

TEST(MatchClass, agreesWithVertexByVertexReferenceOnRandomScenes)
{
    std::mt19937 random(3);
    int meaningful = 0;
    for (int round = 0; round < 500; ++round) {
        const Reference r = randomScene(random);
        EvaluationProtocol protocol;
        protocol.minPoints = r.minPoints;
        for (const int cls : {1, 2})
            for (const double threshold : {0.25, 0.5, 0.75}) {
                const double expected = r.ap(cls, threshold);
                const double got = scannetArea(matchClass(countsOf(r), cls, threshold, protocol));
                if (std::isnan(expected)) {
                    EXPECT_TRUE(std::isnan(got));
                    continue;
                }
                EXPECT_NEAR(got, expected, 1e-12);
                meaningful += expected > 0 && expected < 1 ? 1 : 0;
            }
    }
    EXPECT_GT(meaningful, 200) << "the scenes must be neither trivial nor hopeless";
}
