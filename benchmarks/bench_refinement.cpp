// SPDX-License-Identifier: BSD-3-Clause
/** What a refinement costs in one room, and in the last of many: it must be the same. */
#include "BenchmarkFrames.h"
#include "pipeline/Refinement.h"
#include "support/Rooms.h"

#include <benchmark/benchmark.h>

namespace voxeland::benchmarks
{
namespace
{
constexpr int PITCH = 24;  //!< blocks between rooms; more than a room is wide at 5 cm

void refineLastOfRooms(benchmark::State& state)
{
    const auto rooms = static_cast<int>(state.range(0));
    const auto frames = static_cast<uint32_t>(benchmarkFrames().frames.size());
    SemanticVoxelMap map = test::manyRooms(filledMap(), rooms, PITCH, frames);
    const MapperConfig config;
    MappingCounts counts;
    counts.frames = static_cast<uint32_t>(rooms) * frames;
    const uint32_t since = counts.frames - frames;
    for (auto _ : state) refine(map, *config.association, config.refinement, since, false, counts);
    state.SetLabel("budget 2 ms");
}

BENCHMARK(refineLastOfRooms)->Arg(1)->Arg(200)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace voxeland::benchmarks
