// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/CocoPredictions.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <string>
#include <vector>

namespace voxeland
{
/** Predictions from a file, for the frames of a dataset or a rawlog. */
class MatchedPredictions
{
 public:
    /** \param predictions must live as long
     *  \param frames all there are, in their order
     *  \throws InputError if images cannot be matched, or more than a tenth of the predictions have
     *  no frame, or with strict predictions any */
    MatchedPredictions(const CocoPredictions& predictions, const std::vector<DatasetFrame>& frames);

    /** Number of predictions for a frame. \param position among the frames */
    [[nodiscard]] size_t countFor(size_t position) const;

    /** Predictions for a frame, without timestamp, label and sensor pose; odd ones are left out.
     *  Polygons are scaled from the size that the file lists the image with. Null if the file lists
     *  images and the frame's is not among them.
     *  \param position among the frames \param width,height size of its colour image
     *  \throws InputError if the file's masks are of another size, or the image is listed lying the
     *  other way */
    [[nodiscard]] CObservationInstances::Ptr instancesFor(size_t position, int width, int height);

    /** How images were matched to frames, and what else was found out about the file: a sentence
     *  each, for the user. */
    [[nodiscard]] std::vector<std::string> notes() const;
    /** What was left out and what is doubtful, for the user. */
    [[nodiscard]] std::vector<std::string> warnings() const;

 private:
    struct Scale
    {
        double x = 1, y = 1;
    };

    /** Whether a mask is of an image of this size. \throws InputError if it is not, as most are */
    [[nodiscard]] bool fits(const CocoPredictions::Image& image,
                            const CocoPredictions::Entry& entry, int width, int height) const;
    /** By what an image's polygons are stretched to a frame's size. \throws InputError if it is
     *  listed lying the other way */
    [[nodiscard]] Scale scaleOf(const CocoPredictions::Image& image, int width, int height);
    void checkWithoutFrame();

    const CocoPredictions& m_predictions;
    ImageMatching m_matching;
    LeftOut m_leftOut;
    std::string m_scaled;        //!< what is said of polygons of another size
    std::string m_withoutFrame;  //!< what is said of predictions without a frame
};
}  // namespace voxeland
