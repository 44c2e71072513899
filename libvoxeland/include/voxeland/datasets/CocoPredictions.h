// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/CategoryNames.h"
#include "voxeland/observations/CObservationInstances.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
struct DatasetFrame;

/** What a detector found, from a file in the COCO results format: a list of
 *  {"image_id", "category_id", "score", "bbox", "segmentation"}, also as the list "annotations" of
 *  an object with "images" and "categories", as ground truth comes.
 *
 *  - segmentation: run lengths, compressed or not, or polygons.
 *  - category: "category_name", or "category_id" looked up in the file's own "categories", the
 * names given, and COCO's. "class_scores", an object of scores by category name or number, becomes
 *    the distribution; without it the one category is certain and "score" says how sure.
 *  - score: in [0,1], 1 if absent. bbox: the mask's if absent. track_id: optional.
 *  - image_id is the frame's number, unless "images" lists files: then their names decide, and
 *    frames that are not listed have no predictions (otherwise: nothing was found in them). */
class CocoPredictions
{
 public:
    /** Reads and checks the whole file.
     *  \param names further category names, which win over COCO's
     *  \throws InputError, naming the file and the prediction, for anything that is not right */
    explicit CocoPredictions(const std::string& file, const CategoryNames& names = {});

    /** Number of predictions in the file. */
    [[nodiscard]] size_t count() const;
    /** Number of predictions for a frame. */
    [[nodiscard]] size_t countFor(const DatasetFrame& frame) const;

    /** Predictions for a frame, without timestamp, label and sensor pose. Null if the file does not
     *  list the frame's image.
     *  \param width,height size of the frame's colour image
     *  \throws InputError if the masks are of another size */
    [[nodiscard]] CObservationInstances::Ptr instancesFor(const DatasetFrame& frame, int width,
                                                          int height) const;

 private:
    /** A prediction whose polygons, if any, wait for the size of the image. */
    struct Entry
    {
        InstancePrediction prediction;
        std::vector<std::vector<double>> polygons;
    };
    friend class CocoReader;

    /** Number of the frame's image in the file, if it may be there. */
    [[nodiscard]] std::optional<int64_t> imageOf(const DatasetFrame& frame) const;

    std::string m_file;
    std::map<int64_t, std::vector<Entry>> m_entries;  //!< by image
    bool m_listsImages = false;
    std::map<std::string, int64_t> m_imageByPath;  //!< from "images"; also by the bare file name
};
}  // namespace voxeland
