// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/PixelBox.h"
#include "voxeland/map/CategoryEvidence.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>

#include <functional>
#include <map>
#include <vector>

namespace voxeland
{
/** How an image showed an instance: enough to find the image again and to say how good it is. */
struct InstanceView
{
    uint32_t frame = 0;            //!< number of the frame, from 0, of those mapped
    mrpt::Clock::time_point time;  //!< timestamp of the frame: finds it in the rawlog
    PixelBox box;                  //!< around the object, in the colour image [pixels]
    uint32_t area = 0;             //!< pixels of the object
    bool truncated = false;        //!< whether the border of the image may cut the object
    float score = 0;               //!< confidence of the detection, in [0,1]
    float probability = 0;         //!< that the detection gave to the view's category, in [0,1]
    mrpt::math::TPoint3Df camera;  //!< optical centre, in the map's frame [m]
    mrpt::math::TPoint3Df target;  //!< middle of what was seen, in the map's frame [m]

    /** From the camera to the object, of length 1. */
    [[nodiscard]] mrpt::math::TPoint3Df direction() const;
    /** How well it shows the object: its size [pixels] weighted by confidence, halved if it may be
     * cut. */
    [[nodiscard]] float quality() const;
    /** Whether an image can have shown that: places and quality are finite, and quality is not
     * negative. */
    [[nodiscard]] bool isPossible() const;
};

/** The best views of an instance, by the category each spoke for: so many of each category. Of each
 * direction of view (some 25 degrees wide) the best one counts first, then the second best and so
 * on; among those of the same rank the better one (see InstanceView::quality(), the earlier of
 * equals). So what is kept of a category does not depend on the order in which views come, nor on
 * how instances were merged. */
class InstanceViews
{
 public:
    using ByCategory = std::map<category_id_t, std::vector<InstanceView>>;

    /** The views, those counted first at the front. */
    [[nodiscard]] const ByCategory& byCategory() const { return m_views; }
    /** Views that spoke for a category; empty if there are none. */
    [[nodiscard]] const std::vector<InstanceView>& of(category_id_t category) const;

    /** Views that are not possible are left out. \param most views to keep of the category */
    void add(category_id_t category, const InstanceView& view, uint32_t most);
    /** Adds all of another instance's views. */
    void add(const InstanceViews& other, uint32_t most);
    /** Moves the views for which `belongs` is true to another instance. */
    void moveTo(InstanceViews& other, const std::function<bool(const InstanceView&)>& belongs,
                uint32_t most);

 private:
    ByCategory m_views;
};
}  // namespace voxeland
