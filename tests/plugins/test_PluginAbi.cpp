// SPDX-License-Identifier: BSD-3-Clause
/** What plugins and the library hand each other has the layout of this version of the interface. */
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <gtest/gtest.h>

#include <typeinfo>

using namespace voxeland;

#define STRINGIFIED(x) #x
#define AS_TEXT(x) STRINGIFIED(x)

/** When this fails: count VOXELAND_PLUGIN_ABI up, and write the new sizes here. */
TEST(PluginAbi, IsCountedUpWhenALayoutChanges)
{
#if defined(__x86_64__) && _GLIBCXX_USE_CXX11_ABI && !defined(_GLIBCXX_DEBUG)
    EXPECT_STREQ(AS_TEXT(VOXELAND_PLUGIN_ABI), "abi_5");
    EXPECT_EQ(sizeof(OptionList), 56U);
    EXPECT_EQ(sizeof(Opinion), 88U);
    EXPECT_EQ(sizeof(VoxelizedFrame), 184U);
    EXPECT_EQ(sizeof(Overlap), 40U);
    EXPECT_EQ(sizeof(OpinionOverlaps), 80U);
    EXPECT_EQ(sizeof(InstanceOverlap), 32U);
    EXPECT_EQ(sizeof(MergeThresholds), 32U);
    EXPECT_EQ(sizeof(Assignment), 8U);
    EXPECT_EQ(sizeof(Instance), 288U);
    EXPECT_EQ(sizeof(VoxelEvidence), 40U);
    EXPECT_EQ(sizeof(MapOptions), 64U);
    EXPECT_EQ(sizeof(SemanticVoxelMap), 592U);
    EXPECT_EQ(sizeof(DisambiguationPicture), 96U);
    EXPECT_EQ(sizeof(DisambiguationQuestion), 88U);
    EXPECT_EQ(sizeof(DisambiguationAnswer), 88U);
#else
    GTEST_SKIP() << "the sizes are those of 64-bit x86 and GCC's library";
#endif
}

TEST(PluginAbi, IsPartOfTheNamesOfAllBases)
{
    for (const std::type_info* base : {&typeid(Plugin), &typeid(CAssociationPolicy),
                                       &typeid(COpinionConverter), &typeid(CDisambiguator)})
        EXPECT_NE(std::string(base->name()).find(AS_TEXT(VOXELAND_PLUGIN_ABI)), std::string::npos)
            << base->name();
}
