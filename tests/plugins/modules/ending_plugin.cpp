// SPDX-License-Identifier: BSD-3-Clause
/** A plugin that ends its program as the environment variable VOXELAND_TEST_ENDING says. */
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/plugins/CAssociationPolicy.h"

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace
{
void end(const std::string& how)
{
    const char* variable = std::getenv("VOXELAND_TEST_ENDING");
    if (variable == nullptr || variable != how) return;
    if (how == "abort") std::abort();
    if (how == "exit") std::exit(0);
    if (how == "crash") std::raise(SIGSEGV);
    throw std::runtime_error("no \x1B[2Jlicence");
}
}  // namespace

namespace voxeland
{
class CEndingAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CEndingAssociation, voxeland)

 public:
    CEndingAssociation() { end("throw"); }
    [[nodiscard]] std::string description() const override { return "a plugin of the tests"; }
    void declareOptions(OptionList&) override {}
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>&,
                                                    const SemanticVoxelMap&) const override
    {
        return {};
    }
    [[nodiscard]] bool mayMerge(const InstanceOverlap&, const MergeThresholds&,
                                const SemanticVoxelMap&) const override
    {
        return false;
    }
};

IMPLEMENTS_MRPT_OBJECT(CEndingAssociation, voxeland::CAssociationPolicy, voxeland)
}  // namespace voxeland

namespace
{
struct EndWhileLoading
{
    EndWhileLoading()
    {
        for (const char* how : {"abort", "crash", "exit", "throw while loading"}) end(how);
    }
} const END;
}  // namespace

const voxeland::RegisteredClass<voxeland::CEndingAssociation> REGISTERED;
