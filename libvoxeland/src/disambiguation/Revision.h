// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/plugins/DisambiguationOptions.h"

#include <map>
#include <string>

namespace voxeland
{
/** Lets a back-end say something else than it did in earlier runs on the same map. */
class Revision
{
 public:
    /** \param input the map as it was before those runs
     *  \param source class of the back-end, see Decision::source */
    Revision(const SemanticVoxelMap& input, std::string source);

    /** Takes back what the back-end decided in those runs. \return number of decisions */
    size_t withdraw(SemanticVoxelMap& map) const;
    /** Puts a decision in the place of what the back-end decided about the instance in those runs;
     * nothing changes if it says the same, in the same words. See decide(). */
    void decide(SemanticVoxelMap& map, instance_id_t instance, const Decision& decision,
                const DisambiguationOptions& options) const;

 private:
    [[nodiscard]] std::vector<Decision>::iterator firstSince(Instance& instance) const;
    size_t withdraw(Instance& instance) const;

    std::map<instance_id_t, size_t> m_decisions;  //!< how many each instance had
    std::string m_source;
};
}  // namespace voxeland
