// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/DatasetOptions.h"
#include "voxeland/observations/UnusableFrame.h"
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
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

/** Reads the frames of a public RGB-D dataset one after another. A dataset's own class lists the
 *  frames, describes the cameras and reads one frame; which are wanted, which had to be left out,
 *  and what the user knows better is dealt with here. */
class RgbdDatasetReader
{
 public:
    virtual ~RgbdDatasetReader() = default;
    RgbdDatasetReader(const RgbdDatasetReader&) = delete;
    RgbdDatasetReader& operator=(const RgbdDatasetReader&) = delete;

    /** The dataset's name, for people. */
    [[nodiscard]] virtual std::string name() const = 0;
    /** All frames, by increasing number. */
    [[nodiscard]] const std::vector<DatasetFrame>& frames() const { return m_frames; }

    /** Restricts next() to every so-manieth frame of those numbered first to last.
     *  \throws ConfigurationError if every is 0 or first is behind last */
    void select(int64_t first, int64_t last, size_t every);

    /** Positions in frames() of those next() goes through, those it skips included. */
    [[nodiscard]] std::vector<size_t> selected() const;

    /** Reads the next selected frame that can be used; the unusable ones before it are added to
     *  skipped(). \return false if there are no more
     *  \throws InputError, naming the file, if the dataset is corrupt, and for an unusable frame if
     *  the options are strict */
    bool next(RgbdRecord& record);
    /** Reads one frame, selected or not.
     *  \param index position in frames()
     *  \throws UnusableFrame if it cannot be used, InputError as next() */
    [[nodiscard]] RgbdRecord load(size_t index) const;
    /** The frame that next() read last. */
    [[nodiscard]] const DatasetFrame& frame() const { return m_frames.at(m_current); }
    /** Its position in frames(). */
    [[nodiscard]] size_t position() const { return m_current; }
    [[nodiscard]] const std::vector<SkippedFrame>& skipped() const { return m_skipped; }
    /** What was assumed because the dataset does not say it, or says it in several ways: a sentence
     *  each, for the user. */
    [[nodiscard]] const std::vector<std::string>& notes() const { return m_notes; }

    /** What its poses are taken to be of. */
    [[nodiscard]] PoseAxes poseAxes() const { return m_options.poseAxes; }

 protected:
    explicit RgbdDatasetReader(const DatasetOptions& options) : m_options(options) {}

    /** To be called once, as the last of what read() needs, by the constructor. The user's own
     *  calibration wins over `cameras`. Some frames are read to learn the size of the images.
     *  \throws InputError if it cannot be that of the cameras, see fittedCamera() */
    void setUp(std::vector<DatasetFrame> frames, const DatasetCameras& cameras);
    void addNote(const std::string& sentence) { m_notes.push_back(sentence); }
    [[nodiscard]] const DatasetOptions& options() const { return m_options; }
    /** Reads time, images and pose of a frame; what it throws as UnusableFrame is the reason in a
     *  few words, such as "no pose file".
     *  \param index position in frames()
     *  \throws UnusableFrame to have it skipped, InputError to give up */
    [[nodiscard]] virtual RgbdRecord read(size_t index) const = 0;
    /** What is annotated in a frame; asked only if options() want it.
     *  \param record what read() gave, calibrated \throws as read() */
    [[nodiscard]] virtual CObservationInstances::Ptr annotationOf(size_t index,
                                                                  const RgbdRecord& record) const;

 private:
    /** Sizes of the two images of a frame. */
    struct FrameSizes
    {
        ImageSize depth, colour;

        [[nodiscard]] bool operator<(const FrameSizes& o) const
        {
            return depth == o.depth ? colour < o.colour : depth < o.depth;
        }
    };

    [[nodiscard]] bool isSelected(size_t index) const;
    [[nodiscard]] static FrameSizes sizesOf(const RgbdRecord& record);
    /** Sizes of most frames, of a few all over the dataset; nothing if none of them can be read. */
    [[nodiscard]] std::optional<FrameSizes> usualSizes() const;
    void fitCameras();
    /** read(), decoding no image of more pixels than the usual ones, or 33 million. */
    [[nodiscard]] RgbdRecord readLimited(size_t index) const;
    /** Makes the camera's pose of one that was read as that of its optical axes. */
    void applyPoseOptions(mrpt::math::TPose3D& pose) const;

    DatasetOptions m_options;
    DatasetCameras m_cameras;
    std::optional<FrameSizes> m_sizes;
    std::vector<DatasetFrame> m_frames;
    std::vector<SkippedFrame> m_skipped;
    std::vector<std::string> m_notes;
    int64_t m_first = 0, m_last = std::numeric_limits<int64_t>::max();
    size_t m_every = 1, m_next = 0, m_current = 0;
};

/** Names of the formats openDataset() knows. */
std::vector<std::string> datasetFormats();

/** Opens a dataset.
 *  \param format one of datasetFormats() \param folder where it is, see the readers' own pages
 *  \throws ConfigurationError for another format, or if it has no annotation and the options want
 *  it; InputError if the folder does not hold one */
std::unique_ptr<RgbdDatasetReader> openDataset(const std::string& format, const std::string& folder,
                                               const DatasetOptions& options = {});
}  // namespace voxeland
