// SPDX-License-Identifier: BSD-3-Clause
/** From a frame to evidence in the map: rays, occupancy, geometry, categories. */
#include "BenchmarkFrames.h"
#include "pipeline/Integration.h"

#include <benchmark/benchmark.h>

namespace voxeland::benchmarks
{
namespace
{
void castRaysToHits(benchmark::State& state)
{
    const auto& frames = preparedFrames();
    const MapperConfig config;
    size_t i = 0;
    for (auto _ : state) {
        const auto space =
            castRays(frames[i++ % frames.size()].voxels, config.integration.visibility_margin);
        benchmark::DoNotOptimize(space.size());
    }
    state.SetLabel("budget of raysOccupancyAndEvidence");
}

void updateOccupancy(benchmark::State& state)
{
    const auto& frames = preparedFrames();
    SemanticVoxelMap map = filledMap();
    size_t i = 0;
    for (auto _ : state) integrateOccupancy(frames[i++ % frames.size()].space, map);
    state.SetLabel("budget of raysOccupancyAndEvidence");
}

/** What associating all frames with the filled map decided. */
struct AssociatedFrames
{
    std::vector<std::vector<OpinionOverlaps>> opinions;
    std::vector<std::vector<instance_id_t>> instances, missed;

    explicit AssociatedFrames(SemanticVoxelMap& map)
    {
        const MapperConfig config;
        OverlapFinder finder;
        for (const PreparedFrame& frame : preparedFrames()) {
            opinions.push_back(finder.find(frame, config.integration.sharpness, map));
            instances.push_back(
                resolveAssignments(config.association->associate(opinions.back(), map), map));
            missed.push_back(finder.missed(instances.back(), config.integration.missed_share, map));
        }
    }
};

void raysOccupancyAndEvidence(benchmark::State& state)
{
    const auto& frames = preparedFrames();
    const MapperConfig config;
    SemanticVoxelMap map = filledMap();
    const AssociatedFrames associated(map);
    uint32_t i = 0;
    for (auto _ : state) {
        const size_t n = i++ % frames.size();
        const auto space = castRays(frames[n].voxels, config.integration.visibility_margin);
        integrateOccupancy(space, map);
        integrateGeometry(frames[n], associated.instances[n], associated.missed[n],
                          config.integration, map);
        integrateSemantics(frames[n], associated.opinions[n], associated.instances[n], i,
                           config.integration, map);
    }
    state.SetLabel("budget 1.5 ms");
}

BENCHMARK(castRaysToHits)->Unit(benchmark::kMillisecond);
BENCHMARK(updateOccupancy)->Unit(benchmark::kMillisecond);
BENCHMARK(raysOccupancyAndEvidence)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace voxeland::benchmarks
