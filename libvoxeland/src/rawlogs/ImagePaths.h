// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** Makes sure, before MRPT opens them, that the external images and points of a scan lie in MRPT's
 * folder of images (see RawlogFiles::useImages()), also where links lead.
 *  \param rawlog that it was read from, for the message
 *  \param trusted the user vouches for all paths: they may lie anywhere
 *  \throws InputError, naming the file and --trust-paths, for one that does not, and for a name
 * that is none of a file */
void checkImagePaths(const mrpt::obs::CObservation3DRangeScan& scan, const std::string& rawlog,
                     bool trusted);
}  // namespace voxeland
