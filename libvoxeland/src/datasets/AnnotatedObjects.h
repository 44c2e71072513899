// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/GroundTruth.h"
#include "voxeland/observations/CObservationInstances.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace voxeland
{
/** Whether an annotated category is part of the building, not an object: wall, floor, ceiling. */
bool isStructure(const std::string& category);

/** Says of which object each point of a ground truth is, one after another. */
class PointAnnotator
{
 public:
    explicit PointAnnotator(GroundTruth& truth) : m_truth(truth) {}

    /** The next point is of an object. \param category its name; structure is no object */
    void addObject(uint32_t instance, const std::string& category);
    /** The next point is of no object. */
    void addNone();

 private:
    GroundTruth& m_truth;
    std::map<std::string, uint32_t> m_positions;  //!< of names
};

/** Predictions that say what an annotation says, for each object in an image: its true category,
 *  a score of 1 and its number as track. Objects without a category and structure are left out.
 *  \param objects object of each pixel, row-major; 0: none
 *  \param categoryOf category of an object; empty: none */
CObservationInstances::Ptr predictionsOf(
    const std::vector<uint32_t>& objects, int width, int height,
    const std::function<std::string(uint32_t object)>& categoryOf);
}  // namespace voxeland
