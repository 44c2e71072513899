// SPDX-License-Identifier: BSD-3-Clause
#include "FrameFinder.h"

#include "ImagePaths.h"
#include "RawlogFiles.h"
#include "files/GzInputFile.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

using namespace mrpt::obs;
namespace fs = std::filesystem;

namespace voxeland
{
FrameFinder::FrameFinder(const std::string& file, const InputOptions& options, Times wanted)
    : m_file(file),
      m_options(options),
      m_wanted(std::move(wanted)),
      m_input(std::make_unique<GzInputFile>(RawlogFiles::toRead(file).rawlog.string()))
{
    const RawlogFiles files(file);
    files.useImages();
    if (!fs::exists(files.sidecar)) return;
    GzInputFile sidecar(files.sidecar.string());
    while (const auto object = sidecar.readObject()) take(object);
}

FrameFinder::~FrameFinder() = default;

double FrameFinder::progress() const
{
    return m_input->progress();
}

std::optional<RgbdFrame> FrameFinder::next()
{
    for (;;) {
        if (!m_waiting.empty()) {
            const auto predictions = m_predictions.find(m_waiting.front().scan->timestamp);
            const bool found = predictions != m_predictions.end();
            if (found || m_ended || m_waiting.size() > m_options.prediction_wait) {
                RgbdFrame frame = std::move(m_waiting.front());
                m_waiting.pop_front();
                if (found) frame.instances = predictions->second;
                return frame;
            }
        }
        if (m_ended) return std::nullopt;
        const auto object = m_input->readObject();
        if (object)
            take(object);
        else
            m_ended = true;
    }
}

void FrameFinder::take(const std::shared_ptr<mrpt::serialization::CSerializable>& object)
{
    if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
        takeObservation(observation);
    } else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
        for (const auto& o : *frame) takeObservation(o);
    } else if (const auto map = std::dynamic_pointer_cast<mrpt::maps::CSimpleMap>(object)) {
        for (const auto& keyframe : *map) take(keyframe.sf);
    }
}

void FrameFinder::takeObservation(const std::shared_ptr<CObservation>& observation)
{
    if (m_wanted.count(observation->timestamp) == 0) return;
    const auto isFrom = [&](const std::string& label) {
        return label.empty() || label == observation->sensorLabel;
    };
    if (const auto predictions = std::dynamic_pointer_cast<CObservationInstances>(observation)) {
        if (isFrom(m_options.instances_sensor_label))
            m_predictions[observation->timestamp] = predictions;
    } else if (const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) {
        if (!isFrom(m_options.depth_sensor_label)) return;
        checkImagePaths(*scan, m_file, m_options.trust_paths);
        m_waiting.push_back({scan, nullptr, {}});
    }
}
}  // namespace voxeland
