// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
struct DatasetFrame;

/** An image that a file of predictions is about. */
struct PredictedImage
{
    std::string id;    //!< as in the file, for messages
    std::string name;  //!< of the image's file, with or without its ending; may be empty
    std::optional<int64_t> number;  //!< the id, if it is a number
    size_t predictions = 0;         //!< for it
};

/** Which image of a file of predictions each frame is. */
struct ImageMatching
{
    std::vector<std::optional<size_t>> imageOf;  //!< by position of the frame
    std::string how;    //!< for the user: "by file name", "in the order of its images", ...
    std::string doubt;  //!< what speaks against it, for the user; empty if nothing does
};

/** Matches images to frames: by the names of their files if any is the same, with as much of the
 *  folders as both give and without regard to the ending, or to what annotation tools add; else in
 *  their order, if the file lists all images; else by number, which may be a frame's number, that
 *  of its image's file, or its position from 0 or 1. Listed images that are not in the order of
 *  their names count by their numbers if these are just the frames'.
 *  \param listed the file has a list of its images, of which some may have no predictions
 *  \throws InputError if neither names nor order nor numbers tell; without the file's name */
ImageMatching matchImages(const std::vector<PredictedImage>& images, bool listed,
                          const std::vector<DatasetFrame>& frames);
}  // namespace voxeland
