// SPDX-License-Identifier: BSD-3-Clause
#include "FramePreparer.h"

#include "voxeland/observations/UnusableFrame.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace voxeland
{
FramePreparer::FramePreparer(const SemanticMapper& mapper, Source source, unsigned threads)
    : m_mapper(mapper), m_source(std::move(source))
{
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    if (threads == 1) return;
    m_results.resize(2 * threads);
    m_workers.reserve(threads);
    try {
        start(threads);
    } catch (...) {
        stop();
        throw;
    }
}

void FramePreparer::start(unsigned threads)
{
    try {
        while (m_workers.size() < threads) m_workers.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
        // Those that there are do the work, or next() alone.
    }
}

FramePreparer::~FramePreparer()
{
    stop();
}

void FramePreparer::stop()
{
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_stop = true;
    }
    m_changed.notify_all();
    for (std::thread& worker : m_workers) worker.join();
}

std::optional<PreparedFrame> FramePreparer::next()
{
    if (m_workers.empty()) {
        const auto frame = m_source();
        if (!frame) return std::nullopt;
        return m_mapper.prepare(*frame);
    }
    std::unique_lock<std::mutex> lock(m_mutex);
    Result& next = resultOf(m_nextWanted);
    m_changed.wait(lock, [&] { return next.isReady; });
    if (next.error) {
        try {
            std::rethrow_exception(next.error);
        } catch (const UnusableFrame&) {
            next = Result();
            ++m_nextWanted;
            m_changed.notify_all();
            throw;
        }
    }
    if (!next.frame) return std::nullopt;
    Result result = std::exchange(next, Result());
    ++m_nextWanted;
    m_changed.notify_all();
    return std::move(result.frame);
}

void FramePreparer::work()
{
    for (;;) {
        size_t ticket = 0;
        std::optional<RgbdFrame> frame;
        Result result;
        bool isLast = false;
        {
            const std::lock_guard<std::mutex> reading(m_reading);
            if (m_isRead) return;
            {
                std::unique_lock<std::mutex> lock(m_mutex);
                m_changed.wait(lock, [this] {
                    return m_stop || m_nextTicket < m_nextWanted + m_results.size();
                });
                if (m_stop) return;
                ticket = m_nextTicket++;
            }
            try {
                frame = m_source();
                isLast = !frame;
            } catch (const UnusableFrame&) {
                result.error = std::current_exception();
            } catch (...) {
                result.error = std::current_exception();
                isLast = true;
            }
            m_isRead = isLast;
        }
        if (frame) {
            try {
                result.frame = m_mapper.prepare(*frame);
            } catch (...) {
                result.error = std::current_exception();
            }
        }
        {
            const std::lock_guard<std::mutex> lock(m_mutex);
            result.isReady = true;
            resultOf(ticket) = std::move(result);
        }
        m_changed.notify_all();
    }
}
}  // namespace voxeland
