// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RgbdDatasetReader.h"
#include "voxeland/observations/PoseTrack.h"

#include <filesystem>

namespace voxeland
{
/** The RGB-D dataset of TU Munich: `rgb.txt` and `depth.txt` (lines `timestamp file`),
 *  `groundtruth.txt` (lines `timestamp tx ty tz qx qy qz qw`), and the images they name.
 *
 *  - A frame is a colour image with the depth image nearest in time, at most 20 ms away; an image
 *    goes to one frame only, closest pairs first.
 *  - It has the time of its depth image, and the pose interpolated there, between poses at most
 *    0.1 s apart.
 *  - 5000 in a depth image make a metre. Depth is registered to colour.
 *  - The camera is that of "freiburg1", "freiburg2" or "freiburg3" (also "fr1" ...) in the folder's
 *    name, with its lens distortion.
 *  - What lines may look like is told by TimedLines and Trajectory; odd ones are left out.
 *  - Frames are numbered by the lines of `rgb.txt`, from 0.
 *
 *  A frame without a depth image or a pose is skipped. */
class TumReader : public RgbdDatasetReader
{
 public:
    /** \throws InputError if a list is missing, malformed or empty; NothingToMapError, with both
     * ranges of times, if those of the lists have nothing in common; ConfigurationError if the
     *  folder's name does not tell the camera, and the options don't either */
    explicit TumReader(const std::string& folder, const DatasetOptions& options = {});

    [[nodiscard]] std::string name() const override { return "TUM RGB-D"; }

 protected:
    [[nodiscard]] RgbdRecord read(size_t index) const override;

 private:
    /** An image of a list. */
    struct TimedFile
    {
        double time = 0;  //!< [s since 1970]
        std::string file;
    };
    std::vector<TimedFile> readList(const std::string& name);
    static std::vector<double> listed(const std::vector<TimedFile>& list);
    static TimeRange timesOf(const std::vector<TimedFile>& list);
    /** \throws NothingToMapError, with both, unless times overlap those of the depth images */
    void checkTimes(const std::string& name, const TimeRange& times,
                    const TimeRange& depthTimes) const;

    std::filesystem::path m_folder;
    std::vector<TimedFile> m_colour, m_depth;
    std::vector<int64_t> m_depthOfColour;  //!< place in the list of depths, -1 for none
    PoseTrack m_poses;                     //!< of the optical axes
};
}  // namespace voxeland
