// SPDX-License-Identifier: BSD-3-Clause
// A plugin: an opinion belongs to the instance with which it has most voxels in common.

#include <voxeland/base/RegisteredClass.h>
#include <voxeland/plugins/CAssociationPolicy.h>

namespace example
{
using namespace voxeland;

class CLargestOverlap : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CLargestOverlap, example)

 public:
    std::string description() const override { return "the instance with most common voxels"; }

    void declareOptions(OptionList& options) override
    {
        options.add("min_voxels", m_minVoxels, {1, 1e6}, "Fewest voxels in common of a match");
    }

    std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                      const SemanticVoxelMap&) const override
    {
        std::vector<Assignment> result;
        for (const OpinionOverlaps& opinion : opinions) {
            Assignment best{UNKNOWN_INSTANCE, static_cast<uint32_t>(result.size())};
            uint32_t most = m_minVoxels - 1;
            for (const Overlap& candidate : opinion.candidates)
                if (candidate.intersection > most) {
                    most = candidate.intersection;
                    best.instance = candidate.instance;
                }
            result.push_back(best);
        }
        return result;
    }

    bool mayMerge(const InstanceOverlap& overlap, const MergeThresholds& thresholds,
                  const SemanticVoxelMap&) const override
    {
        return overlap.iou() > thresholds.iou;
    }

 private:
    uint32_t m_minVoxels = 3;
};

IMPLEMENTS_MRPT_OBJECT(CLargestOverlap, voxeland::CAssociationPolicy, example)
}  // namespace example

const voxeland::RegisteredClass<example::CLargestOverlap> REGISTERED;
