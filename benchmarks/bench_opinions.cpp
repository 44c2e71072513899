// SPDX-License-Identifier: BSD-3-Clause
/** From pixels to opinions. */
#include "BenchmarkFrames.h"

#include <benchmark/benchmark.h>

namespace voxeland::benchmarks
{
namespace
{
void unprojectToVoxels(benchmark::State& state)
{
    const auto& frames = benchmarkFrames().frames;
    const MapperConfig config;
    size_t i = 0;
    for (auto _ : state) {
        const VoxelizedFrame voxels(frames[i++ % frames.size()], config.map.resolution,
                                    config.input.depth);
        benchmark::DoNotOptimize(voxels.hits().data());
    }
    state.SetLabel("budget of unprojectAndCluster");
}

void clusterMasks(benchmark::State& state)
{
    const auto& frames = benchmarkFrames().frames;
    const auto& prepared = preparedFrames();
    size_t i = 0, masks = 0;
    for (auto _ : state) {
        const size_t n = i++ % frames.size();
        if (!frames[n].instances) continue;
        for (const InstancePrediction& prediction : frames[n].instances->instances) {
            const auto cluster = mainCluster(prepared[n].voxels, prediction.mask, {});
            benchmark::DoNotOptimize(cluster.data());
            ++masks;
        }
    }
    state.counters["masks"] =
        benchmark::Counter(static_cast<double>(masks), benchmark::Counter::kAvgIterations);
    state.SetLabel("budget of unprojectAndCluster");
}

void unprojectAndCluster(benchmark::State& state)
{
    const auto& frames = benchmarkFrames().frames;
    const MapperConfig config;
    size_t i = 0;
    for (auto _ : state) {
        const RgbdFrame& frame = frames[i++ % frames.size()];
        const VoxelizedFrame voxels(frame, config.map.resolution, config.input.depth);
        const auto opinions = config.converter->convert(frame, voxels);
        benchmark::DoNotOptimize(opinions.data());
    }
    state.SetLabel("budget 1.0 ms");
}

BENCHMARK(unprojectToVoxels)->Unit(benchmark::kMillisecond);
BENCHMARK(clusterMasks)->Unit(benchmark::kMillisecond);
BENCHMARK(unprojectAndCluster)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace voxeland::benchmarks
