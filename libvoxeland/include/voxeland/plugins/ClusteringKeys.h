// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/Opinion.h"
#include "voxeland/plugins/OptionList.h"

namespace voxeland
{
/** The INI keys by which converters let users tune mainCluster(). */
void declareClusteringOptions(OptionList& list, ClusteringOptions& options);
}  // namespace voxeland
