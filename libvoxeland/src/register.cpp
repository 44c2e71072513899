// SPDX-License-Identifier: BSD-3-Clause
/** Makes the library's classes known to MRPT as soon as the library is loaded. */
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/observations/CObservationInstances.h"

#include <mrpt/core/initializer.h>
#include <mrpt/rtti/CObject.h>

MRPT_INITIALIZER(registerVoxelandClasses)
{
    mrpt::rtti::registerClass(CLASS_ID(voxeland::CObservationInstances));
    mrpt::rtti::registerClass(CLASS_ID(voxeland::CVoxelandMap));
}
