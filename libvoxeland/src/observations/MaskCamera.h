// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace mrpt::img
{
class TCamera;
}
namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
class CObservationInstances;

/** Camera whose pixels the masks of a frame's predictions are made of: the colour camera if the
 *  scan has a calibrated one, otherwise the depth camera. */
const mrpt::img::TCamera& maskCamera(const mrpt::obs::CObservation3DRangeScan& scan);

/** Why predictions cannot be those of a scan, in a sentence: they are of images of another size
 * than its maskCamera() takes. Empty: nothing is wrong. */
std::string misfitOf(const CObservationInstances& predictions,
                     const mrpt::obs::CObservation3DRangeScan& scan);

/** Makes predictions those of a scan: its timestamp, sensor label and sensor pose. */
void attachToScan(CObservationInstances& predictions,
                  const mrpt::obs::CObservation3DRangeScan& scan);
}  // namespace voxeland
