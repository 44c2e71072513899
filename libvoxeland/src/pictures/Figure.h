// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "ViewCamera.h"
#include "ViewColoring.h"

namespace voxeland
{
/** A page with a title, a picture on the left and its legend on the right. */
class Figure
{
 public:
    /** \param height of the page [px]; it is half as wide again */
    explicit Figure(int height);

    /** Size of the picture of a page of this height [px]. */
    static cv::Size pictureSize(int height);

    void drawTitle(const std::string& text);
    /** \param picture of pictureSize(), BGR */
    void drawPicture(const cv::Mat3b& picture);
    /** Writes labels into the picture at their places, but those that would cover an earlier one.
     *  \param camera that made the picture */
    void drawLabels(const std::vector<ViewColoring::Label>& labels, const ViewCamera& camera);
    /** Draws a bar of a round number of metres. \param pixelsPerMetre of the picture */
    void drawScale(float pixelsPerMetre);
    /** Draws the directions of the map's axes. */
    void drawAxes(const VoxelScene& scene, const ViewCamera& camera);
    /** Draws colour bar and entries; says how many entries found no room. */
    void drawLegend(const ViewColoring& coloring);

    [[nodiscard]] const cv::Mat3b& image() const { return m_image; }

 private:
    void write(const std::string& text, cv::Point baseline, double size = 1, bool halo = false);
    /** \return the row below the bar */
    int drawBar(double maximum, int row);

    cv::Mat3b m_image;
    double m_unit;  //!< page height / 1000 [px]
};
}  // namespace voxeland
