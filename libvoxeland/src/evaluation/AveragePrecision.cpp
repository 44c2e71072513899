// SPDX-License-Identifier: BSD-3-Clause
#include "AveragePrecision.h"

#include <algorithm>
#include <limits>

namespace voxeland
{
namespace
{
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr size_t NONE = std::numeric_limits<size_t>::max();

/** One scene's part of matchClass(). */
class SceneMatching
{
 public:
    SceneMatching(const EvaluatedScene& scene, class_id_t cls, double threshold,
                  const EvaluationProtocol& protocol, RankedMatches& matches)
        : m_scene(scene),
          m_class(cls),
          m_threshold(threshold),
          m_protocol(protocol),
          m_matches(matches)
    {
    }

    void run()
    {
        m_used.assign(m_scene.instances.size(), false);
        m_overlaps.assign(m_scene.instances.size(), false);
        m_entryOfObject.assign(m_scene.objects.size(), NONE);
        for (const SharedPoints& o : m_scene.overlaps)
            if (isCandidate(o)) match(o);
        countObjects();
        addFalsePositives();
    }

 private:
    [[nodiscard]] bool counts(const PredictedInstance& i) const
    {
        return i.cls == m_class && i.points > 0 && i.points >= m_protocol.minPoints;
    }
    [[nodiscard]] bool counts(const TrueObject& o) const
    {
        return o.cls == m_class && o.points >= m_protocol.minPoints;
    }
    [[nodiscard]] bool isCandidate(const SharedPoints& o) const
    {
        return m_scene.objects[o.object].cls == m_class && counts(m_scene.instances[o.instance]) &&
               iou(m_scene, o) > m_threshold;
    }

    void match(const SharedPoints& o)
    {
        m_overlaps[o.instance] = true;
        if (!counts(m_scene.objects[o.object]) || m_used[o.instance]) return;
        const double score = m_scene.instances[o.instance].score;
        size_t& entry = m_entryOfObject[o.object];
        if (entry == NONE) {
            entry = m_matches.entries.size();
            m_matches.entries.push_back({score, true});
            m_used[o.instance] = true;
            return;
        }
        RankedMatches::Entry& found = m_matches.entries[entry];
        const double lower = std::min(found.score, score);
        found.score = std::max(found.score, score);
        m_matches.entries.push_back({lower, false});
    }

    void countObjects()
    {
        for (size_t i = 0; i < m_scene.objects.size(); ++i) {
            if (!counts(m_scene.objects[i])) continue;
            ++m_matches.objects;
            if (m_entryOfObject[i] == NONE) ++m_matches.missed;
        }
    }

    void addFalsePositives()
    {
        const std::vector<size_t> ignorable = ignorablePoints(m_scene, m_protocol);
        for (size_t i = 0; i < m_scene.instances.size(); ++i) {
            const PredictedInstance& instance = m_scene.instances[i];
            if (!counts(instance) || m_overlaps[i]) continue;
            const double share =
                static_cast<double>(ignorable[i]) / static_cast<double>(instance.points);
            if (share <= m_threshold) m_matches.entries.push_back({instance.score, false});
        }
    }

    const EvaluatedScene& m_scene;
    class_id_t m_class;
    double m_threshold;
    const EvaluationProtocol& m_protocol;
    RankedMatches& m_matches;
    std::vector<bool> m_used;             //!< instances that found an object
    std::vector<bool> m_overlaps;         //!< instances with an object of the class above threshold
    std::vector<size_t> m_entryOfObject;  //!< where the match of an object is, or NONE
};
}  // namespace

RankedMatches matchClass(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                         double iouThreshold, const EvaluationProtocol& protocol)
{
    RankedMatches matches;
    for (const EvaluatedScene& s : scenes)
        SceneMatching(s, cls, iouThreshold, protocol, matches).run();
    return matches;
}

std::vector<PrecisionRecall> precisionRecall(const RankedMatches& matches)
{
    auto sorted = matches.entries;
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.score > b.score; });
    std::vector<PrecisionRecall> curve;
    size_t correct = 0;
    for (size_t i = 0; i < sorted.size(); ++i) {
        if (sorted[i].correct) ++correct;
        if (i + 1 < sorted.size() && sorted[i + 1].score == sorted[i].score) continue;
        const double objects = static_cast<double>(matches.objects);
        curve.push_back({static_cast<double>(correct) / static_cast<double>(i + 1),
                         objects > 0 ? static_cast<double>(correct) / objects : 0});
    }
    std::reverse(curve.begin(), curve.end());
    return curve;
}

double scannetArea(const RankedMatches& matches)
{
    if (matches.objects == 0) return NOT_A_NUMBER;
    std::vector<PrecisionRecall> curve = precisionRecall(matches);
    if (curve.empty()) return 0;
    curve.push_back({1, 0});
    double area = 0;
    for (size_t i = 0; i < curve.size(); ++i) {
        const double before = curve[i == 0 ? 0 : i - 1].recall;
        const double after = i + 1 < curve.size() ? curve[i + 1].recall : 0;
        area += curve[i].precision * (before - after) / 2;
    }
    return area;
}

double vocArea(const RankedMatches& matches)
{
    if (matches.objects == 0) return NOT_A_NUMBER;
    const std::vector<PrecisionRecall> curve = precisionRecall(matches);
    double area = 0, best = 0;
    for (size_t i = 0; i < curve.size(); ++i) {  // from the highest recall down
        best = std::max(best, curve[i].precision);
        const double next = i + 1 < curve.size() ? curve[i + 1].recall : 0;
        area += best * (curve[i].recall - next);
    }
    return area;
}

AveragePrecision averagePrecision(const std::vector<EvaluatedScene>& scenes, class_id_t cls,
                                  const EvaluationProtocol& protocol)
{
    AveragePrecision result;
    constexpr int FIRST = 50, LAST = 90, STEP = 5;  // integers: 0.05 has no exact double
    for (int percent = FIRST; percent <= LAST; percent += STEP) {
        const RankedMatches matches = matchClass(scenes, cls, percent / 100.0, protocol);
        const double area = scannetArea(matches);
        result.ap += area;
        if (percent != FIRST) continue;
        result.ap50 = area;
        result.voc50 = vocArea(matches);
    }
    result.ap /= (LAST - FIRST) / STEP + 1;
    result.ap25 = scannetArea(matchClass(scenes, cls, 0.25, protocol));
    return result;
}
}  // namespace voxeland
