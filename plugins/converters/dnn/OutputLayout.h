// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Detection.h"
#include "Letterbox.h"
#include "Network.h"

namespace voxeland
{
/** How a network writes what it found. */
enum class OutputLayout
{
    automatic,  //!< to be recognized
    yolov5,
    yolov8,  //!< and v11
    maskRcnn
};

/** The layout of these outputs, recognized from their shapes, or checked if it is named.
 *  \param named the layout to read them in, or automatic
 *  \throws InputError, with the shapes, if they have no layout that is known, or cannot be read in
 *  the one named */
OutputLayout recognizeLayout(const std::vector<NetworkOutput>& outputs, OutputLayout named);

/** How many classes a network of this layout tells apart, from the shapes of its outputs. */
int numberOfClasses(OutputLayout layout, const std::vector<NetworkOutput>& outputs);

/** What the outputs say is in the image.
 *  \param layout that of the outputs, not automatic */
std::vector<Detection> decode(OutputLayout layout, const std::vector<NetworkOutput>& outputs,
                              const Letterbox& letterbox, const DetectionLimits& limits);
}  // namespace voxeland
