// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/FramePredictor.h"

#include "voxeland/observations/UnusableFrame.h"

namespace voxeland
{
FramePredictor::FramePredictor(const SemanticMapper& mapper, FramePreparer::Source source)
    : m_mapper(mapper), m_source(std::move(source))
{
    if (mapper.config().converter->makesPredictions()) m_worker = std::thread([this] { work(); });
}

FramePredictor::~FramePredictor()
{
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_stop = true;
    }
    m_changed.notify_all();
    if (m_worker.joinable()) m_worker.join();
}

std::optional<RgbdFrame> FramePredictor::next()
{
    if (!m_worker.joinable()) return m_source();
    std::unique_lock<std::mutex> lock(m_mutex);
    m_changed.wait(lock, [this] { return !m_ready.empty(); });
    if (m_ready.front().isLast) {
        if (m_ready.front().error) std::rethrow_exception(m_ready.front().error);
        return std::nullopt;
    }
    const Result result = std::move(m_ready.front());
    m_ready.pop_front();
    m_changed.notify_all();
    if (result.error) std::rethrow_exception(result.error);
    return result.frame;
}

void FramePredictor::work()
{
    for (bool isLast = false; !isLast;) {
        Result result;
        try {
            result.frame = m_source();
            result.isLast = !result.frame;
            if (result.frame) m_mapper.predict(*result.frame);
        } catch (const UnusableFrame&) {
            result.error = std::current_exception();
        } catch (...) {
            result = {std::nullopt, std::current_exception(), true};
        }
        isLast = result.isLast;
        std::unique_lock<std::mutex> lock(m_mutex);
        m_changed.wait(lock, [this] { return m_stop || m_ready.size() < CAPACITY; });
        if (m_stop) return;
        m_ready.push_back(std::move(result));
        m_changed.notify_all();
    }
}
}  // namespace voxeland
