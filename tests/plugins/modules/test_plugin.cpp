// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/plugins/CAssociationPolicy.h"

namespace voxeland
{
/** A policy of a third party: never matches anything. */
class CTestAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CTestAssociation, voxeland)

 public:
    [[nodiscard]] std::string description() const override { return "a plugin of the tests"; }
    void declareOptions(OptionList& options) override
    {
        options.add("patience", m_patience, {0, 10}, "A key of the tests' plugin");
    }
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                                    const SemanticVoxelMap&) const override
    {
        std::vector<Assignment> assignments(opinions.size());
        for (uint32_t i = 0; i < assignments.size(); ++i) assignments[i].newInstance = i;
        return assignments;
    }
    [[nodiscard]] bool mayMerge(const InstanceOverlap&, const MergeThresholds&,
                                const SemanticVoxelMap&) const override
    {
        return false;
    }

 private:
    int m_patience = 3;
};

IMPLEMENTS_MRPT_OBJECT(CTestAssociation, voxeland::CAssociationPolicy, voxeland)
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CTestAssociation> REGISTERED;
