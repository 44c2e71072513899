// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** Sets the range image from a 16 bit image file; 65535, some sensors' "too far", becomes 0.
 *  \throws InputError, naming the file, if it is damaged or something else */
void loadDepth(mrpt::obs::CObservation3DRangeScan& scan, const std::string& file);

/** Sets the colour image from a file and remembers where it came from (isExternallyStored()).
 *  \throws InputError, naming the file, if it is damaged or something else */
void loadColour(mrpt::obs::CObservation3DRangeScan& scan, const std::string& file);
}  // namespace voxeland
