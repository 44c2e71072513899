// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/LeftOut.h"
#include "voxeland/datasets/CategoryNames.h"
#include "voxeland/datasets/ImageMatching.h"
#include "voxeland/observations/CObservationInstances.h"

#include <string>
#include <vector>

namespace voxeland
{
/** What a detector found, from a file in the COCO results format: a list of
 *  {"image_id", "category_id", "score", "bbox", "segmentation"}, also as JSON Lines, lists by
 * image, or the list "annotations", "predictions" or "results" of an object with "images" and
 *  "categories", as ground truth comes.
 *
 *  - segmentation: run lengths, compressed or not, or polygons.
 *  - category: "category_name", or "category_id" looked up in the names given, the file's own
 *    "categories", and COCO's: its 90 categories, or its 80 counted from 0 or 1 where those leave
 *    fewer without a name, and in the files of Ultralytics. "class_scores", an object of scores by
 *    category name or number, becomes the distribution; without it the one category is certain and
 *    "score" says how sure.
 *  - score: in [0,1] but for rounding, 1 if absent. bbox: the mask's if absent. track_id: optional,
 *    and none if it is null.
 *  - image_id is a number, or the name of the image's file with or without its ending; "file_name"
 *    may stand for it. Which frames these are is for MatchedPredictions to say.
 *  - width and height of a listed image are those of the image that polygons were drawn on.
 *
 *  Odd entries are left out, and the rest is used. */
class CocoPredictions
{
 public:
    /** A prediction whose mask is made for one image after the other: it may be large. */
    struct Entry
    {
        size_t place = 0;               //!< in the file, from 0
        InstancePrediction prediction;  //!< without a mask
        RunLengthMask columns;          //!< the mask transposed, its runs going down the columns
        std::vector<std::vector<double>> polygons;  //!< instead, if any
    };
    /** An image, with what was found in it. */
    struct Image
    {
        std::string id;     //!< as in the file
        std::string name;   //!< of its file; may be empty
        int width, height;  //!< that its polygons and boxes are drawn in [pixels]; 0 if not said
        std::vector<Entry> entries;
    };

    /** Reads and checks the whole file.
     *  \param names if there are any, they alone and the file's own name categories
     *  \param strict an odd entry is an error
     *  \throws InputError, naming the file and the prediction, if none of them can be used, or the
     *  file as a whole is not right */
    explicit CocoPredictions(const std::string& file, const CategoryNames& names = {},
                             bool strict = false);

    [[nodiscard]] const std::string& file() const { return m_file; }
    /** Number of predictions that can be used. */
    [[nodiscard]] size_t count() const;
    [[nodiscard]] const std::vector<Image>& images() const { return m_images; }
    /** Whether the file lists its images: others were not looked at. Else all were, and nothing was
     *  found in others. */
    [[nodiscard]] bool listsImages() const { return m_listsImages; }
    /** Size of most masks that are given as run lengths [pixels]; 0 if none is. */
    [[nodiscard]] int maskWidth() const { return m_maskWidth; }
    [[nodiscard]] int maskHeight() const { return m_maskHeight; }

    /** Whether odd entries are errors. */
    [[nodiscard]] bool isStrict() const { return m_isStrict; }
    [[nodiscard]] const LeftOut& leftOut() const { return m_leftOut; }
    /** What was found out about the file, a sentence each, for the user. */
    [[nodiscard]] const std::vector<std::string>& notes() const { return m_notes; }
    /** What may be meant otherwise, a sentence each, for the user. */
    [[nodiscard]] const std::vector<std::string>& doubts() const { return m_doubts; }

 private:
    friend class CocoReader;

    std::string m_file;
    std::vector<Image> m_images;
    bool m_listsImages = false;
    int m_maskWidth = 0, m_maskHeight = 0;
    bool m_isStrict;
    LeftOut m_leftOut;
    std::vector<std::string> m_notes, m_doubts;
};
}  // namespace voxeland
