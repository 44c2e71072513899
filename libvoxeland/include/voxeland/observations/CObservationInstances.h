// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/RunLengthMask.h"

#include <mrpt/math/TPose3D.h>
#include <mrpt/obs/CObservation.h>

#include <string>
#include <vector>

namespace voxeland
{
/** One category with its share of a distribution. */
struct CategoryProbability
{
    std::string name;       //!< category name, e.g. "dining table"
    float probability = 0;  //!< in [0,1]

    friend bool operator==(const CategoryProbability& a, const CategoryProbability& b)
    {
        return a.name == b.name && a.probability == b.probability;
    }
};

/** A distribution over category names, the most probable first; it sums to 1. */
using CategoryDistribution = std::vector<CategoryProbability>;

/** Sorts by decreasing probability (ties by name), adds up equal names, drops non-positive entries
 *  and scales the rest so that it sums to 1. Empty if nothing positive and finite is left. */
CategoryDistribution normalized(CategoryDistribution scores);

/** What a detector says of one object in one image. */
struct InstancePrediction
{
    static constexpr int64_t NO_TRACK = -1;

    RunLengthMask mask;               //!< pixels of the colour image; masks may overlap
    CategoryDistribution categories;  //!< what it may be
    float score = 0;                  //!< confidence of the detection, in [0,1]
    PixelBox box;                     //!< the detector's box, in pixels of the colour image
    int64_t track = NO_TRACK;         //!< identity over time, from a tracker or ground truth
};

/** Instance predictions for one image: goes with the CObservation3DRangeScan of the same timestamp.
 *  Serializable, so that rawlogs and simplemaps can hold it. */
class CObservationInstances : public mrpt::obs::CObservation
{
    DEFINE_SERIALIZABLE(CObservationInstances, voxeland)

 public:
    int32_t imageWidth = 0, imageHeight = 0;    //!< size of the image the masks belong to [pixels]
    std::vector<InstancePrediction> instances;  //!< in the detector's order
    mrpt::math::TPose3D sensorPoseOnRobot;      //!< pose of the camera on the robot

    void getSensorPose(mrpt::poses::CPose3D& out) const override;
    void setSensorPose(const mrpt::poses::CPose3D& pose) override;
    void getDescriptionAsText(std::ostream& o) const override;

    [[nodiscard]] bool exportTxtSupported() const override { return true; }
    [[nodiscard]] std::string exportTxtHeader() const override;
    [[nodiscard]] std::string exportTxtDataRow() const override;
};
}  // namespace voxeland
