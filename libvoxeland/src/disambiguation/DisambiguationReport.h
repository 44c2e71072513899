// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/disambiguation/DisambiguationRun.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>
#include <vector>

namespace voxeland
{
/** What a question changed. */
struct ReportedQuestion
{
    QuestionOutcome outcome;
    std::string before, after;  //!< most probable category
    double probabilityBefore = 0, probabilityAfter = 0;
    double entropyBefore = 0, entropyAfter = 0;  //!< [nat]
};

/** What a run asked, and what came of it. */
class DisambiguationReport
{
 public:
    /** Remembers an instance as it is before a decision; call before any. */
    void before(const SemanticVoxelMap& map, instance_id_t instance);
    /** Completes it with the outcome. \param map with the decision */
    void after(const SemanticVoxelMap& map, QuestionOutcome outcome);

    /** Those whose outcome is known, ordered by instance. */
    [[nodiscard]] std::vector<ReportedQuestion> questions() const;
    /** A table and a line of totals, to be read. */
    [[nodiscard]] std::string asText() const;
    /** The same, with answers, as JSON. */
    [[nodiscard]] std::string asJson(const SemanticVoxelMap& map) const;

 private:
    struct Entry
    {
        ReportedQuestion question;
        bool known = false;
    };
    std::map<instance_id_t, Entry> m_entries;
};
}  // namespace voxeland
