// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/MaskCamera.h"

#include "voxeland/observations/CObservationInstances.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace voxeland
{
const mrpt::img::TCamera& maskCamera(const mrpt::obs::CObservation3DRangeScan& scan)
{
    const bool calibrated = scan.hasIntensityImage && scan.cameraParamsIntensity.fx() > 0;
    return calibrated ? scan.cameraParamsIntensity : scan.cameraParams;
}

void attachToScan(CObservationInstances& predictions,
                  const mrpt::obs::CObservation3DRangeScan& scan)
{
    predictions.timestamp = scan.timestamp;
    predictions.sensorLabel = scan.sensorLabel;
    predictions.setSensorPose(scan.sensorPose);
}
}  // namespace voxeland
