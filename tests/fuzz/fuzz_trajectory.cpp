// SPDX-License-Identifier: BSD-3-Clause
/** Trajectories in TUM's format. */
#include "Reading.h"
#include "observations/Trajectory.h"

using namespace voxeland;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const fuzz::MadeUpFile file("poses.tum");
    return fuzz::readOrRefuse([&] {
        const auto trajectory = Trajectory::fromTumFile(file.holding(data, size), 0.25);
        for (const double seconds : {-1e9, 0.0, 1000.05, 1e9, 1e10})
            static_cast<void>(trajectory.poses.at(mrpt::Clock::fromDouble(seconds)));
    });
}
