// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/rtti/CObject.h>

namespace voxeland
{
/** Makes a class known to MRPT's class factory when its library is loaded:
 *
 *      IMPLEMENTS_MRPT_OBJECT(CMine, voxeland::CAssociationPolicy, mine)
 *      const voxeland::RegisteredClass<mine::CMine> REGISTERED;
 *
 *  It belongs behind IMPLEMENTS_MRPT_OBJECT in the same file, as objects of one file come to life
 * in their order. MRPT_INITIALIZER may run before the class's id does: built by clang, it does. */
template <class Class>
struct RegisteredClass
{
    RegisteredClass() { mrpt::rtti::registerClass(CLASS_ID(Class)); }
};
}  // namespace voxeland
