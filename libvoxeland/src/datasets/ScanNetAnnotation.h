// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "ScanNetCategories.h"
#include "voxeland/observations/CObservationInstances.h"

#include <filesystem>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
constexpr double SCANNET_EPOCH = 1483228800;  //!< 2017-01-01 00:00:00 UTC [s]

/** ScanNet's annotated images in a scene's folder: `instance-filt/N.png` (8 bit, object number) and
 *  `label-filt/N.png` (16 bit, number of a raw category), of the size of colour images; or
 *  `instance/` and `label/`. Categories are NYU40's, see ScanNetCategories. */
class ScanNetAnnotation
{
 public:
    /** \throws InputError if there are no such folders, or no table of categories */
    explicit ScanNetAnnotation(const std::filesystem::path& sceneFolder);

    /** What is annotated in a frame, see predictionsOf(); an object has the category that most of
     *  its pixels have.
     *  \param scan the frame's, with its colour image
     *  \throws UnusableFrame if there are no such images, InputError if they are damaged or of
     *  another size than the colour image */
    [[nodiscard]] CObservationInstances::Ptr instancesOf(
        int64_t frame, const mrpt::obs::CObservation3DRangeScan& scan) const;

 private:
    std::filesystem::path m_instances, m_labels;
    ScanNetCategories m_categories;
};
}  // namespace voxeland
