// SPDX-License-Identifier: BSD-3-Clause
/** Runs all benchmarks; options are Google Benchmark's. */
#include "BenchmarkFrames.h"

#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>

int main(int argc, char** argv)
try {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    const auto& frames = voxeland::benchmarks::benchmarkFrames();
    benchmark::AddCustomContext("frames", std::to_string(frames.frames.size()) + " of 640x480, " +
                                              frames.origin + "; times are of one frame");
    benchmark::RunSpecifiedBenchmarks();
    return 0;
} catch (const std::exception& e) {
    std::cerr << "voxeland_benchmarks: " << e.what() << "\n";
    return 1;
}
