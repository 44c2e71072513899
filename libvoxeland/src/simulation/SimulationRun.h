// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/rawlogs/RgbdRawlogWriter.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <cstddef>
#include <functional>
#include <string>

namespace voxeland::simulation
{
/** Where a simulation goes. */
struct SimulationOutput
{
    std::string rawlog;  //!< target, ending in .rawlog
    RgbdRawlogWriter::Options rawlogOptions;
    std::string groundTruthFolder;  //!< see TrueSurfaces; empty: none
    unsigned threads = 0;           //!< frames computed at the same time; 0: one a core
};

/** What was made. */
struct SimulationSummary
{
    size_t rooms = 0, objects = 0, frames = 0;
    size_t predictions = 0;        //!< in all frames
    size_t groundTruthPoints = 0;  //!< seen by the camera; 0 without ground truth
};

/** Simulates all frames and writes them, with the ground truth where wanted. The files depend on
 *  the options only, not on the number of threads.
 *  \param progress called with the number of frames written so far
 *  \throws ConfigurationError, OutputError */
SimulationSummary runSimulation(const SimulationOptions& options, const SimulationOutput& output,
                                const std::function<void(size_t)>& progress);
}  // namespace voxeland::simulation
