// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/COpinionConverter.h"

IMPLEMENTS_VIRTUAL_MRPT_OBJECT(Plugin, mrpt::rtti::CObject, voxeland)
IMPLEMENTS_VIRTUAL_MRPT_OBJECT(COpinionConverter, voxeland::Plugin, voxeland)
IMPLEMENTS_VIRTUAL_MRPT_OBJECT(CAssociationPolicy, voxeland::Plugin, voxeland)
IMPLEMENTS_VIRTUAL_MRPT_OBJECT(CDisambiguator, voxeland::Plugin, voxeland)
