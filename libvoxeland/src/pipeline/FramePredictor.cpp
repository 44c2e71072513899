// SPDX-License-Identifier: BSD-3-Clause
#include "FramePredictor.h"

#include "voxeland/observations/UnusableFrame.h"

#include <system_error>
#include <utility>

namespace voxeland
{
FramePredictor::FramePredictor(const SemanticMapper& mapper, FramePreparer::Source source)
    : m_mapper(mapper), m_source(std::move(source))
{
    try {
        if (mapper.config().converter->makesPredictions())
            m_worker = std::thread([this] { work(); });
    } catch (const std::system_error&) {
        // Where there is no thread to be had, next() does it.
    }
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

std::optional<RgbdFrame> FramePredictor::predicted()
{
    auto frame = m_source();
    if (frame) m_mapper.predict(*frame);
    return frame;
}

std::optional<RgbdFrame> FramePredictor::next()
{
    if (!m_worker.joinable()) return predicted();
    std::unique_lock<std::mutex> lock(m_mutex);
    m_changed.wait(lock, [this] { return m_given > m_taken; });
    Result& next = m_ready[m_taken % CAPACITY];
    if (next.isLast) {
        if (next.error) std::rethrow_exception(next.error);
        return std::nullopt;
    }
    const Result result = std::exchange(next, Result());
    ++m_taken;
    m_changed.notify_all();
    if (result.error) std::rethrow_exception(result.error);
    return result.frame;
}

void FramePredictor::work()
{
    for (bool isLast = false; !isLast;) {
        Result result;
        try {
            result.frame = predicted();
            result.isLast = !result.frame;
        } catch (const UnusableFrame&) {
            result.error = std::current_exception();
        } catch (...) {
            result = {std::nullopt, std::current_exception(), true};
        }
        isLast = result.isLast;
        std::unique_lock<std::mutex> lock(m_mutex);
        m_changed.wait(lock, [this] { return m_stop || m_given - m_taken < CAPACITY; });
        if (m_stop) return;
        m_ready[m_given++ % CAPACITY] = std::move(result);
        m_changed.notify_all();
    }
}
}  // namespace voxeland
