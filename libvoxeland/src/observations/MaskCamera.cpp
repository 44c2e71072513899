// SPDX-License-Identifier: BSD-3-Clause
#include "MaskCamera.h"

#include "DepthImageCheck.h"
#include "base/sizeText.h"
#include "voxeland/observations/CObservationInstances.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace voxeland
{
const mrpt::img::TCamera& maskCamera(const mrpt::obs::CObservation3DRangeScan& scan)
{
    const bool calibrated = scan.hasIntensityImage && scan.cameraParamsIntensity.fx() > 0;
    return calibrated ? scan.cameraParamsIntensity : scan.cameraParams;
}

std::string misfitOf(const CObservationInstances& predictions,
                     const mrpt::obs::CObservation3DRangeScan& scan)
{
    const mrpt::img::TCamera& camera = maskCamera(scan);
    if (predictions.imageWidth == static_cast<int>(camera.ncols) &&
        predictions.imageHeight == static_cast<int>(camera.nrows))
        return {};
    return frameName(scan) + " has predictions for images of " +
           sizeText(predictions.imageWidth, predictions.imageHeight) +
           " pixels but a colour camera of " + sizeText(camera.ncols, camera.nrows) +
           ": make the predictions at the camera's size";
}

void attachToScan(CObservationInstances& predictions,
                  const mrpt::obs::CObservation3DRangeScan& scan)
{
    predictions.timestamp = scan.timestamp;
    predictions.sensorLabel = scan.sensorLabel;
    predictions.setSensorPose(scan.sensorPose);
}
}  // namespace voxeland
