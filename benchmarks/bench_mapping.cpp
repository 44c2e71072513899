// SPDX-License-Identifier: BSD-3-Clause
/** A frame's whole way into the map, without decoding its images. */
#include "BenchmarkFrames.h"

#include <benchmark/benchmark.h>

namespace voxeland::benchmarks
{
namespace
{
void mapFrame(benchmark::State& state)
{
    const auto& frames = benchmarkFrames().frames;
    SemanticMapper mapper = defaultMapper();
    SemanticVoxelMap map = filledMap();
    MappingCounts counts;
    size_t i = 0;
    for (auto _ : state) mapper.integrate(mapper.prepare(frames[i++ % frames.size()]), map, counts);
    state.SetLabel("budget 3 ms");
}

void mapFrameIntoEmptyMap(benchmark::State& state)
{
    const auto& frames = benchmarkFrames().frames;
    SemanticMapper mapper = defaultMapper();
    SemanticVoxelMap map(mapper.config().map);
    MappingCounts counts;
    size_t i = 0;
    for (auto _ : state) {
        if (i % frames.size() == 0) map.clear();
        mapper.integrate(mapper.prepare(frames[i++ % frames.size()]), map, counts);
    }
    state.SetLabel("budget 3 ms; map emptied before the first of the frames");
}

BENCHMARK(mapFrame)->Unit(benchmark::kMillisecond);
BENCHMARK(mapFrameIntoEmptyMap)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace voxeland::benchmarks
