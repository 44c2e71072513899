// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "FramePreparer.h"

#include <array>

namespace voxeland
{
/** Where the converter makes predictions itself, lets it do so ahead of mapping, in a thread of its
 * own: in order and for every frame, so that results do not depend on timing. Few frames are held.
 * Where it does not, frames pass as they are. */
class FramePredictor
{
 public:
    /** \param mapper must outlive this \param source called by one thread at a time */
    FramePredictor(const SemanticMapper& mapper, FramePreparer::Source source);
    ~FramePredictor();
    FramePredictor(const FramePredictor&) = delete;
    FramePredictor& operator=(const FramePredictor&) = delete;

    /** The next frame, or none at the end; to be called by one thread at a time. What reading it or
     * making its predictions threw is thrown again here; after an UnusableFrame the next call gives
     * the frame behind it. */
    std::optional<RgbdFrame> next();

 private:
    /** The next frame, with its predictions. */
    std::optional<RgbdFrame> predicted();
    /** Makes predictions until there are no more frames, or nobody wants them. */
    void work();
    static constexpr size_t CAPACITY = 4;

    /** A frame, or what went wrong, or neither: the end. */
    struct Result
    {
        std::optional<RgbdFrame> frame;
        std::exception_ptr error;
        bool isLast = false;
    };

    const SemanticMapper& m_mapper;
    FramePreparer::Source m_source;
    std::mutex m_mutex;  //!< guards all below
    std::condition_variable m_changed;
    std::array<Result, CAPACITY> m_ready;
    size_t m_given = 0, m_taken = 0;  //!< results so far: put there, and taken from there
    bool m_stop = false;
    std::thread m_worker;
};
}  // namespace voxeland
