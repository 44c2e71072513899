// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/version.h>

/** \file Everything that differs between the MRPT versions supported (2.5.8 and newer 2.x). */

// MRPT 2.14 added the namespace to the macro that declares an abstract class.
#if MRPT_VERSION >= 0x020e00
#define VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CLASS) DEFINE_VIRTUAL_MRPT_OBJECT(CLASS, voxeland)
#else
#define VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CLASS) DEFINE_VIRTUAL_MRPT_OBJECT(CLASS)
#endif

// MRPT 2.13 made map factories return a smart pointer.
#if MRPT_VERSION >= 0x020d00
#include <memory>
#define VOXELAND_MAP_FACTORY_RESULT std::shared_ptr<mrpt::maps::CMetricMap>
#else
#define VOXELAND_MAP_FACTORY_RESULT mrpt::maps::CMetricMap*
#endif
