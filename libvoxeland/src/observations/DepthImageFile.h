// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** Loads a scan's depth image if that is in a file of its own, as MRPT's load() does, but believes
 *  nothing of a file that is cut off, damaged or something else. MRPT's own lets a map be made of
 *  whatever was in memory, or crashes.
 *
 *  Layout of a `.bin` file, inside gzip: rows and columns [uint32], then rows * columns numbers
 *  [uint16], all little endian. Text files, as MRPT writes matrices, are read by MRPT.
 *  \throws UnusableFrame, naming the file, if it cannot be read whole */
void loadDepthImage(const mrpt::obs::CObservation3DRangeScan& scan);
}  // namespace voxeland
