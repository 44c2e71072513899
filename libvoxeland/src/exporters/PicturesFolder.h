// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"

namespace voxeland
{
/** exportViews(). */
Exporter picturesExporter();
}  // namespace voxeland
