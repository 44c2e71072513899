// SPDX-License-Identifier: BSD-3-Clause
#include "DisambiguationReport.h"

#include "base/ClassicNumbers.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/hiddenTexts.h"
#include "voxeland/base/printable.h"
#include "voxeland/map/MapQueries.h"

#include <mrpt/core/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace voxeland
{
namespace
{
using json_t = nlohmann::ordered_json;

/** The category as it was, or what it became. */
std::string categoriesOf(const ReportedQuestion& q)
{
    const std::string before = printable(q.before);
    return q.before == q.after ? before : before + " -> " + printable(q.after);
}

/** The most probable category. */
RankedCategory topOf(const SemanticVoxelMap& map, const Instance& instance)
{
    const auto ranked = categoryDistribution(map, instance);
    return ranked.empty() ? RankedCategory{UNKNOWN_CATEGORY_ID, UNKNOWN_CATEGORY, 0}
                          : ranked.front();
}
}  // namespace

void DisambiguationReport::before(const SemanticVoxelMap& map, instance_id_t instance)
{
    ReportedQuestion& q = m_entries[instance].question;
    const RankedCategory top = topOf(map, map.instance(instance));
    q.before = top.name;
    q.probabilityBefore = top.probability;
    q.entropyBefore = categoryEntropy(map, map.instance(instance));
}

void DisambiguationReport::after(const SemanticVoxelMap& map, QuestionOutcome outcome)
{
    const instance_id_t instance = outcome.instance;
    Entry& entry = m_entries[instance];
    ReportedQuestion& q = entry.question;
    const RankedCategory top = topOf(map, map.instance(instance));
    q.after = top.name;
    q.probabilityAfter = top.probability;
    q.entropyAfter = categoryEntropy(map, map.instance(instance));
    q.outcome = std::move(outcome);
    entry.known = true;
}

std::vector<ReportedQuestion> DisambiguationReport::questions() const
{
    std::vector<ReportedQuestion> known;
    for (const auto& [id, entry] : m_entries)
        if (entry.known) known.push_back(entry.question);
    return known;
}

std::string DisambiguationReport::asText() const
{
    const auto all = questions();
    size_t width = std::string("category").size();
    for (const auto& q : all) width = std::max(width, categoriesOf(q).size());
    std::string text = format("%6s  %-*s  %-14s  entropy         seconds   tokens  who\n", "id",
                              static_cast<int>(width), "category", "prob.");
    size_t decided = 0, changed = 0;
    uint64_t tokens = 0;
    double cost = 0;
    for (const auto& q : all) {
        const auto& d = q.outcome.decision;
        text += format("%6u  %-*s  ", q.outcome.instance, static_cast<int>(width),
                       categoriesOf(q).c_str());
        if (!d) {
            text += printableSentence(q.outcome.problem) + "\n";
            continue;
        }
        text += format("%.2f -> %.2f    %.3f -> %.3f  %7.1f  %7llu  %s\n", q.probabilityBefore,
                       q.probabilityAfter, q.entropyBefore, q.entropyAfter, d->seconds,
                       static_cast<unsigned long long>(d->promptTokens + d->answerTokens),
                       printable(d->model).c_str());
        ++decided;
        changed += q.before == q.after ? 0 : 1;
        tokens += d->promptTokens + d->answerTokens;
        cost += d->cost;
    }
    text += format("asked about %s: %zu decided, %zu of them changed category",
                   counted(all.size(), "object").c_str(), decided, changed);
    if (tokens > 0) text += "; " + counted(tokens, "token");
    if (cost > 0) text += format(", cost %.4f", cost);
    return text + "\n";
}

std::string DisambiguationReport::asJson(const SemanticVoxelMap& map) const
{
    json_t json = json_t::array();
    for (const auto& q : questions()) {
        json_t entry = {{"instance", q.outcome.instance},
                        {"before",
                         {{"category", q.before},
                          {"probability", q.probabilityBefore},
                          {"entropy", q.entropyBefore}}},
                        {"after",
                         {{"category", q.after},
                          {"probability", q.probabilityAfter},
                          {"entropy", q.entropyAfter}}}};
        if (const auto& d = q.outcome.decision) {
            entry["decision"] = {{"category", map.categories().name(d->category)},
                                 {"source", d->source},
                                 {"model", d->model},
                                 {"answer", d->answer},
                                 {"questions", d->questions},
                                 {"seconds", d->seconds},
                                 {"prompt_tokens", d->promptTokens},
                                 {"answer_tokens", d->answerTokens},
                                 {"cost", d->cost}};
        } else {
            entry["problem"] = withoutHidden(q.outcome.problem);
            entry["failed"] = q.outcome.failed;
        }
        json.push_back(std::move(entry));
    }
    return json_t{{"questions", json}}.dump(2, ' ', false, json_t::error_handler_t::replace) + "\n";
}
}  // namespace voxeland
