// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include <cstdint>
#include <string>
#include <unordered_map>

namespace voxeland
{
/** SceneNN's annotated mesh as seen by a frame: a pixel belongs to the object whose vertices are
 *  most where it was measured (in a cube of 2.5 cm, or the nearest one beside it). */
class SceneNNAnnotation
{
 public:
    /** \throws InputError as readSceneNNGroundTruth() */
    explicit SceneNNAnnotation(const std::string& sceneFolder);

    /** What is annotated in a frame, see predictionsOf().
     *  \param record the frame, calibrated, with its pose */
    [[nodiscard]] CObservationInstances::Ptr instancesOf(const RgbdRecord& record) const;

 private:
    [[nodiscard]] uint32_t objectAt(double x, double y, double z) const;

    std::unordered_map<uint64_t, uint32_t> m_objects;        //!< by cube; 0: none
    std::unordered_map<uint32_t, std::string> m_categories;  //!< of the objects
};
}  // namespace voxeland
