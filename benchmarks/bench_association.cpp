// SPDX-License-Identifier: BSD-3-Clause
/** Which instance an opinion is about, in a map that has seen the place. */
#include "BenchmarkFrames.h"

#include <benchmark/benchmark.h>

namespace voxeland::benchmarks
{
namespace
{
void findOverlaps(benchmark::State& state)
{
    const auto& frames = preparedFrames();
    const double sharpness = MapperConfig().integration.sharpness;
    SemanticVoxelMap map = filledMap();
    OverlapFinder finder;
    size_t i = 0;
    for (auto _ : state) {
        const auto overlaps = finder.find(frames[i++ % frames.size()], sharpness, map);
        benchmark::DoNotOptimize(overlaps.data());
    }
    state.SetLabel("budget of associate");
}

void associate(benchmark::State& state)
{
    const auto& frames = preparedFrames();
    const MapperConfig config;
    SemanticVoxelMap map = filledMap();
    OverlapFinder finder;
    size_t i = 0;
    for (auto _ : state) {
        const auto overlaps =
            finder.find(frames[i++ % frames.size()], config.integration.sharpness, map);
        const auto assignments = config.association->associate(overlaps, map);
        benchmark::DoNotOptimize(assignments.data());
    }
    state.SetLabel("budget 0.2 ms");
}

BENCHMARK(findOverlaps)->Unit(benchmark::kMillisecond);
BENCHMARK(associate)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace voxeland::benchmarks
