// SPDX-License-Identifier: BSD-3-Clause
/** A damaged or hostile file may name a class of which there are no objects, such as MRPT's bases.
 *  MRPT then prints a line of its own and calls a function that is not there. Its definition is
 *  found after this one, which only throws. */
#include <mrpt/rtti/CObject.h>

#include <stdexcept>

std::shared_ptr<mrpt::rtti::CObject> mrpt::rtti::TRuntimeClassId::createObject() const
{
    if (!ptrCreateObject)
        throw std::runtime_error(std::string("not registered: objects of ") + className);
    return ptrCreateObject();
}
