// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdRawlogWriter.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace voxeland
{
/** One frame a dataset lists, usable or not. */
struct DatasetFrame
{
    int64_t number = 0;  //!< counts from 0; goes on over the ends of sequences
    std::string image;   //!< colour image, relative to the dataset's folder
};

/** A frame that was left out, and why. */
struct SkippedFrame
{
    DatasetFrame frame;
    std::string reason;  //!< e.g. "no pose file"
};

/** Thrown by readers for a frame that cannot be used, the rest of the dataset being fine. */
struct UnusableFrame : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/** Reads the frames of a public RGB-D dataset one after another. A dataset's own class lists the
 *  frames and reads one of them; which are wanted and which had to be left out is counted here. */
class RgbdDatasetReader
{
 public:
    virtual ~RgbdDatasetReader() = default;

    /** The dataset's name, for people. */
    [[nodiscard]] virtual std::string name() const = 0;
    /** All frames, by increasing number. */
    [[nodiscard]] const std::vector<DatasetFrame>& frames() const { return m_frames; }

    /** Restricts next() to every so-manieth frame of those numbered first to last.
     *  \throws ConfigurationError if every is 0 or first is behind last */
    void select(int64_t first, int64_t last, size_t every);
    /** Number of frames next() goes through, those it skips included. */
    [[nodiscard]] size_t selectedCount() const;

    /** Reads the next selected frame that can be used; the unusable ones before it are added to
     *  skipped(). \return false if there are no more
     *  \throws InputError, naming the file, if the dataset is corrupt */
    bool next(RgbdRecord& record);
    /** The frame that next() read last. */
    [[nodiscard]] const DatasetFrame& frame() const { return m_frames.at(m_current); }
    [[nodiscard]] const std::vector<SkippedFrame>& skipped() const { return m_skipped; }

 protected:
    /** To be called once, by the constructor. */
    void setFrames(std::vector<DatasetFrame> frames) { m_frames = std::move(frames); }
    /** \param index position in frames()
     *  \throws UnusableFrame to have it skipped, InputError to give up */
    [[nodiscard]] virtual RgbdRecord read(size_t index) const = 0;

 private:
    [[nodiscard]] bool isSelected(size_t index) const;

    std::vector<DatasetFrame> m_frames;
    std::vector<SkippedFrame> m_skipped;
    int64_t m_first = 0, m_last = std::numeric_limits<int64_t>::max();
    size_t m_every = 1, m_next = 0, m_current = 0;
};

/** Names of the formats openDataset() knows. */
std::vector<std::string> datasetFormats();

/** Opens a dataset.
 *  \param format one of datasetFormats() \param folder where it is, see the readers' own pages
 *  \throws ConfigurationError for another format, InputError if the folder does not hold one */
std::unique_ptr<RgbdDatasetReader> openDataset(const std::string& format,
                                               const std::string& folder);
}  // namespace voxeland
