// SPDX-License-Identifier: BSD-3-Clause
#include "CCategoryAssociation.h"

#include "voxeland/base/RegisteredClass.h"

#include <map>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CCategoryAssociation, voxeland::CAssociationPolicy, voxeland)

std::string CCategoryAssociation::description() const
{
    return "one instance for each most probable category: dense semantic mapping";
}

std::vector<Assignment> CCategoryAssociation::associate(
    const std::vector<OpinionOverlaps>& opinions, const SemanticVoxelMap& map) const
{
    using Category = std::optional<category_id_t>;
    std::map<Category, instance_id_t> instanceOf;
    if (!opinions.empty())
        for (const auto& [id, instance] : map.instances())
            instanceOf.try_emplace(instance.evidence().top(), id);

    std::vector<Assignment> assignments;
    std::map<Category, uint32_t> newInstanceOf;
    for (const OpinionOverlaps& o : opinions) {
        const Category category = o.categories.top();
        const auto number = static_cast<uint32_t>(assignments.size());
        Assignment assignment;
        if (const auto at = instanceOf.find(category); at != instanceOf.end())
            assignment.instance = at->second;
        else
            assignment.newInstance = newInstanceOf.try_emplace(category, number).first->second;
        assignments.push_back(assignment);
    }
    return assignments;
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CCategoryAssociation> REGISTERED;
