// SPDX-License-Identifier: BSD-3-Clause
/** What a particle filter asks of the map: how likely a depth scan is at a pose, and copies. */
#include "BenchmarkFrames.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <benchmark/benchmark.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

namespace voxeland::benchmarks
{
namespace
{
CVoxelandMap benchmarkMap()
{
    CVoxelandMap map;
    map.editMap() = filledMap();
    return map;
}

/** A particle not far from the truth. */
mrpt::poses::CPose3D particle(const RgbdFrame& frame, size_t number)
{
    const double error = 0.01 * static_cast<double>(number % 21) - 0.1;
    return mrpt::poses::CPose3D(error, -error, 0, error, 0, 0) + frame.robotPose;
}

void likelihoodOfParticle(benchmark::State& state)
{
    const CVoxelandMap map = benchmarkMap();
    const RgbdFrame& frame = benchmarkFrames().frames.front();
    size_t i = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            map.computeObservationLikelihood(*frame.scan, particle(frame, i++)));
    state.SetLabel("400 points");
}

void firstLikelihoodAfterAChange(benchmark::State& state)
{
    CVoxelandMap map = benchmarkMap();
    const RgbdFrame& frame = benchmarkFrames().frames.front();
    for (auto _ : state) {
        benchmark::DoNotOptimize(&map.editMap());
        benchmark::DoNotOptimize(map.computeObservationLikelihood(*frame.scan, frame.robotPose));
    }
    state.SetLabel("builds the distances");
}

/** What the distance field is instead of. */
void nearestOfKdTree(benchmark::State& state)
{
    const CVoxelandMap map = benchmarkMap();
    const auto* points = map.getAsSimplePointsMap();
    const RgbdFrame& frame = benchmarkFrames().frames.front();
    mrpt::maps::CSimplePointsMap scan;
    const_cast<mrpt::obs::CObservation3DRangeScan&>(*frame.scan).unprojectInto(scan);
    size_t particles = 0;
    for (auto _ : state) {
        const auto pose = particle(frame, particles++) + frame.scan->sensorPose;
        for (size_t i = 0; i < 400; ++i) {
            mrpt::math::TPoint3D p;
            scan.getPoint(i * (scan.size() / 400), p);
            const mrpt::math::TPoint3Df q(pose.composePoint(p));
            float x, y, z, squared;
            benchmark::DoNotOptimize(points->kdTreeClosestPoint3D(q.x, q.y, q.z, x, y, z, squared));
        }
    }
    state.SetLabel("400 points, for comparison");
}

void copyMap(benchmark::State& state)
{
    const CVoxelandMap map = benchmarkMap();
    for (auto _ : state) {
        const CVoxelandMap copy = map;
        benchmark::DoNotOptimize(copy.isEmpty());
    }
    state.SetLabel("shares the voxels");
}

void changeCopy(benchmark::State& state)
{
    const CVoxelandMap map = benchmarkMap();
    for (auto _ : state) {
        CVoxelandMap copy = map;
        benchmark::DoNotOptimize(&copy.editMap());
    }
    state.SetLabel("copies the voxels");
}

void copySetOfMaps(benchmark::State& state)
{
    mrpt::maps::CMultiMetricMap maps;
    maps.maps.push_back(std::make_shared<CVoxelandMap>(benchmarkMap()));
    for (auto _ : state) {
        const mrpt::maps::CMultiMetricMap copy = maps;
        benchmark::DoNotOptimize(copy.isEmpty());
    }
    state.SetLabel("CMultiMetricMap writes and reads its maps");
}

BENCHMARK(likelihoodOfParticle)->Unit(benchmark::kMicrosecond);
BENCHMARK(firstLikelihoodAfterAChange)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestOfKdTree)->Unit(benchmark::kMicrosecond);
BENCHMARK(copyMap)->Unit(benchmark::kMicrosecond);
BENCHMARK(changeCopy)->Unit(benchmark::kMillisecond);
BENCHMARK(copySetOfMaps)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace voxeland::benchmarks
