// SPDX-License-Identifier: BSD-3-Clause
#include "WallMap.h"

#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"
#include "voxeland/observations/CObservationInstances.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace voxeland::test
{
namespace
{
constexpr int WIDTH = 64, HEIGHT = 48;
constexpr uint16_t DEPTH = 2020;  //!< [mm]

mrpt::obs::CObservation3DRangeScan::Ptr makeScan(double time)
{
    using namespace mrpt::literals;
    auto scan = mrpt::obs::CObservation3DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(time);
    scan->sensorLabel = "RGBD";
    scan->hasRangeImage = scan->hasIntensityImage = true;
    scan->rangeUnits = 0.001F;
    scan->range_is_depth = true;
    scan->rangeImage_setSize(HEIGHT, WIDTH);
    scan->rangeImage.fill(DEPTH);
    scan->intensityImage.resize(WIDTH, HEIGHT, mrpt::img::CH_RGB);
    scan->cameraParams.ncols = WIDTH;
    scan->cameraParams.nrows = HEIGHT;
    scan->cameraParams.setIntrinsicParamsFromValues(60, 60, WIDTH / 2.0, HEIGHT / 2.0);
    scan->cameraParamsIntensity = scan->cameraParams;
    scan->relativePoseIntensityWRTDepth =
        mrpt::poses::CPose3D(0, 0, 0, -90.0_deg, 0.0_deg, -90.0_deg);
    return scan;
}

CObservationInstances::Ptr makePredictions(double time)
{
    std::vector<uint8_t> leftHalf;
    for (int i = 0; i < WIDTH * HEIGHT; ++i) leftHalf.push_back(i % WIDTH < WIDTH / 2 ? 1 : 0);
    auto predictions = CObservationInstances::Create();
    predictions->timestamp = mrpt::Clock::fromDouble(time);
    predictions->sensorLabel = "RGBD";
    predictions->imageWidth = WIDTH;
    predictions->imageHeight = HEIGHT;
    InstancePrediction chair;
    chair.mask = RunLengthMask::fromBitmap(leftHalf.data(), WIDTH, HEIGHT);
    chair.categories = {{"chair", 1.0F}};
    chair.score = 0.9F;
    predictions->instances.push_back(chair);
    return predictions;
}
}  // namespace

void writeWallMap(const std::string& file)
{
    CVoxelandMap map;
    for (int frame = 0; frame < 5; ++frame) {
        map.insertObservation(*makePredictions(1e9 + frame), mrpt::poses::CPose3D());
        map.insertObservation(*makeScan(1e9 + frame), mrpt::poses::CPose3D());
    }
    map.flush();
    saveMap(map, file);
}
}  // namespace voxeland::test
