// SPDX-License-Identifier: BSD-3-Clause
#include "SimulationRun.h"

#include "TrueSurfaces.h"
#include "base/ClassicNumbers.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/simulation/Simulator.h"

#include <mrpt/math/CQuaternion.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <deque>
#include <future>
#include <optional>
#include <thread>

namespace voxeland::simulation
{
namespace
{
/** Computes frames ahead of their use, several at a time, and hands them out in order. */
class FramesAhead
{
 public:
    FramesAhead(const Simulator& simulator, unsigned threads)
        : m_simulator(simulator),
          m_ahead(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()))
    {
    }

    [[nodiscard]] bool finished() const { return m_frames.empty() && m_next == m_simulator.size(); }

    SimulatedFrame next()
    {
        while (m_frames.size() < m_ahead && m_next < m_simulator.size())
            m_frames.push_back(std::async(
                std::launch::async, [this, index = m_next++] { return m_simulator.frame(index); }));
        SimulatedFrame frame = m_frames.front().get();
        m_frames.pop_front();
        return frame;
    }

 private:
    const Simulator& m_simulator;
    size_t m_ahead, m_next = 0;
    std::deque<std::future<SimulatedFrame>> m_frames;
};

std::string tumLine(const SimulatedFrame& frame)
{
    mrpt::math::CQuaternionDouble q;
    mrpt::poses::CPose3D(frame.robotPose).getAsQuaternion(q);
    const auto& p = frame.robotPose;
    return format("%.6f %.6f %.6f %.6f %.8f %.8f %.8f %.8f\n",
                  mrpt::Clock::toDouble(frame.timestamp), p.x, p.y, p.z, q.x(), q.y(), q.z(),
                  q.r());
}
}  // namespace

SimulationSummary runSimulation(const SimulationOptions& options, const SimulationOutput& output,
                                const std::function<void(size_t)>& progress)
{
    const Simulator simulator(options);
    RgbdRawlogWriter writer(output.rawlog, output.rawlogOptions);
    std::optional<TrueSurfaces> groundTruth;
    if (!output.groundTruthFolder.empty()) {
        makeOutputFolder(output.groundTruthFolder);
        groundTruth.emplace(simulator.scene(), simulator.camera(), options.groundTruthSpacing,
                            options.camera.maxGroundTruthRange);
    }

    SimulationSummary summary;
    summary.rooms = simulator.scene().rooms().size();
    summary.objects = simulator.scene().objects().size();
    std::string trajectory;
    for (FramesAhead frames(simulator, output.threads); !frames.finished();) {
        const SimulatedFrame frame = frames.next();
        writer.write(simulator.record(frame));
        if (groundTruth) groundTruth->see(frame.exact, frame.truePose);
        trajectory += tumLine(frame);
        summary.predictions += frame.predictions.size();
        progress(++summary.frames);
    }
    if (groundTruth) {
        groundTruth->save(output.groundTruthFolder);
        writeAtomically(output.groundTruthFolder + "/trajectory.tum", trajectory);
        const auto& points = groundTruth->points();
        summary.groundTruthPoints = static_cast<size_t>(
            std::count_if(points.begin(), points.end(), [](const auto& p) { return p.seen; }));
    }
    writer.close();
    return summary;
}
}  // namespace voxeland::simulation
