// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/SimulationOptions.h"

#include "voxeland/base/errors.h"

namespace voxeland::simulation
{
namespace
{
DetectorOptions perfect()
{
    DetectorOptions o;
    o.detectionRate = 1;
    o.halfRateArea = o.halfRateVisible = 0;
    o.scoreThreshold = 0;
    o.falseDetections = 0;
    o.confidence = 20;
    o.unknownConfidence = 20;
    o.logitNoise = 0;
    o.confusedObjects = 0;
    o.boundaryBias = o.boundaryNoise = o.maskShift = 0;
    o.underSegmentation = o.swallowing = o.overSegmentation = o.splitting = o.duplicates = 0;
    return o;
}

DetectorOptions mild()
{
    DetectorOptions o;
    o.detectionRate = 0.95F;
    o.halfRateArea = 200;
    o.halfRateVisible = 0.15F;
    o.falseDetections = 0.03F;
    o.confidence = 4;
    o.logitNoise = 0.5F;
    o.confusedObjects = 0.25F;
    o.confusedSector = 80;
    o.boundaryBias = 0;
    o.boundaryNoise = 0.8F;
    o.maskShift = 0.5F;
    o.underSegmentation = 0.02F;
    o.swallowing = 0.1F;
    o.overSegmentation = 0.02F;
    o.splitting = 0.01F;
    o.duplicates = 0.02F;
    return o;
}

DetectorOptions hard()
{
    DetectorOptions o;
    o.detectionRate = 0.82F;
    o.halfRateArea = 500;
    o.halfRateVisible = 0.3F;
    o.falseDetections = 0.3F;
    o.confidence = 3.3F;
    o.logitNoise = 1.0F;
    o.confusedObjects = 0.65F;
    o.confusedSector = 120;
    o.boundaryBias = 1;
    o.boundaryNoise = 2.5F;
    o.maskShift = 2;
    o.underSegmentation = 0.18F;
    o.swallowing = 0.5F;
    o.overSegmentation = 0.14F;
    o.splitting = 0.08F;
    o.duplicates = 0.14F;
    return o;
}

void require(bool condition, const char* message)
{
    if (!condition) throw ConfigurationError(message);
}
}  // namespace

DetectorOptions DetectorOptions::preset(const std::string& name)
{
    if (name == "perfect") return perfect();
    if (name == "mild") return mild();
    if (name == "realistic") return {};
    if (name == "hard") return hard();
    throw ConfigurationError("there is no detector '" + name +
                             "'; use perfect, mild, realistic or hard");
}

const std::vector<std::string>& DetectorOptions::presets()
{
    static const std::vector<std::string> names{"perfect", "mild", "realistic", "hard"};
    return names;
}

void SimulationOptions::check() const
{
    require(scene.rooms >= 1 && scene.rooms <= 3, "the number of rooms must be 1, 2 or 3");
    require(scene.roomHeight >= 2.2F, "rooms must be at least 2.2 m high");
    require(
        camera.width >= 32 && camera.height >= 24 && camera.width <= 4096 && camera.height <= 4096,
        "the image size must be from 32x24 to 4096x4096 pixels");
    require(camera.frames >= 1, "the number of frames must be at least 1");
    require(camera.frameRate > 0 && camera.focalLength > 0,
            "frame rate and focal length must be positive");
    require(jitter.period >= 1, "the period of the poses' errors must be at least 1 frame");
    require(groundTruthSpacing > 0, "the spacing of ground truth points must be positive");
}
}  // namespace voxeland::simulation
