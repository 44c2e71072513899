// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/SemanticMapper.h"

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace voxeland
{
/** Reads and prepares frames ahead of mapping in several threads, and gives them back in order: the
 * result is the same whatever the number of threads. At most two frames a thread are held. */
class FramePreparer
{
 public:
    /** Gives the next frame, none at the end; called by one thread at a time. */
    using Source = std::function<std::optional<RgbdFrame>()>;

    /** \param mapper must outlive this \param threads 1: everything happens in next(); 0: one a
     * core; as many as the system allows */
    FramePreparer(const SemanticMapper& mapper, Source source, unsigned threads);
    ~FramePreparer();
    FramePreparer(const FramePreparer&) = delete;
    FramePreparer& operator=(const FramePreparer&) = delete;

    /** The next frame, or none at the end. What reading or preparing it threw is thrown again here;
     * after an UnusableFrame the next call gives the frame behind it.
     */
    std::optional<PreparedFrame> next();

 private:
    struct Result
    {
        bool isReady = false;
        std::optional<PreparedFrame> frame;
        std::exception_ptr error;
    };

    void stop();
    void start(unsigned threads);
    void work();
    [[nodiscard]] Result& resultOf(size_t ticket) { return m_results[ticket % m_results.size()]; }

    const SemanticMapper& m_mapper;
    Source m_source;
    std::mutex m_reading;   //!< held while the source is read, so that tickets follow its order
    bool m_isRead = false;  //!< to its end, or to what cannot be read; guarded by m_reading
    std::mutex m_mutex;     //!< guards all below
    std::condition_variable m_changed;
    std::vector<Result> m_results;  //!< of the tickets from m_nextWanted on, one behind the other
    size_t m_nextTicket = 0, m_nextWanted = 0;
    bool m_stop = false;
    std::vector<std::thread> m_workers;
};
}  // namespace voxeland
