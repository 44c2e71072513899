// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFrames.h"

#include "datasets/MatchedPredictions.h"
#include "datasets/SevenScenesReader.h"
#include "voxeland/simulation/Simulator.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <filesystem>

namespace voxeland::benchmarks
{
namespace
{
constexpr int FRAMES = 30;
constexpr int EVERY = 10;  //!< of a sequence of 300 frames at 30 Hz

RgbdFrame frameOf(const RgbdRecord& record)
{
    return {record.scan, record.instances, mrpt::poses::CPose3D(*record.robotPose)};
}

BenchmarkFrames kitchen(const std::filesystem::path& folder)
{
    BenchmarkFrames result{"7-Scenes RedKitchen (real)", {}};
    SevenScenesReader reader(folder.string());
    reader.select(0, FRAMES * EVERY - 1, EVERY);
    const CocoPredictions recorded((folder / "predictions_coco.json").string());
    MatchedPredictions predictions(recorded, reader.frames());
    for (RgbdRecord record; reader.next(record);) {
        record.instances = predictions.instancesFor(reader.position(), 640, 480);
        result.frames.push_back(frameOf(record));
    }
    return result;
}

BenchmarkFrames simulation()
{
    BenchmarkFrames result{"simulated apartment", {}};
    simulation::SimulationOptions options;
    options.scene.rooms = 1;
    options.camera.frames = FRAMES * EVERY;
    const simulation::Simulator simulator(options);
    for (size_t i = 0; i < simulator.size(); i += EVERY)
        result.frames.push_back(frameOf(simulator.record(simulator.frame(i))));
    return result;
}
}  // namespace

const BenchmarkFrames& benchmarkFrames()
{
    static const BenchmarkFrames frames = [] {
        const auto folder = std::filesystem::path(VOXELAND_TEST_DATA) / "7scenes_redkitchen";
        return std::filesystem::exists(folder) ? kitchen(folder) : simulation();
    }();
    return frames;
}

SemanticMapper defaultMapper()
{
    return SemanticMapper(MapperConfig());
}

const std::vector<PreparedFrame>& preparedFrames()
{
    static const auto prepared = [] {
        const SemanticMapper mapper = defaultMapper();
        std::vector<PreparedFrame> all;
        for (const RgbdFrame& frame : benchmarkFrames().frames)
            all.push_back(mapper.prepare(frame));
        return all;
    }();
    return prepared;
}

const SemanticVoxelMap& filledMap()
{
    static const SemanticVoxelMap filled = [] {
        SemanticMapper mapper = defaultMapper();
        SemanticVoxelMap map(mapper.config().map);
        MappingCounts counts;
        for (const PreparedFrame& frame : preparedFrames()) mapper.integrate(frame, map, counts);
        return map;
    }();
    return filled;
}
}  // namespace voxeland::benchmarks
