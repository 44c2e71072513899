// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"
#include "voxeland/simulation/Recognition.h"
#include "voxeland/simulation/SceneRenderer.h"

#include <vector>

namespace voxeland::simulation
{
/** An instance segmentation network with the faults real ones have, as far as DetectorOptions says.
 *  It knows the true identity of every pixel and spoils it. */
class NoisyDetector
{
 public:
    /** Keeps a reference to the scene. \param random decides what is confused with what */
    NoisyDetector(const Scene& scene, const RenderCamera& camera, const DetectorOptions& options,
                  Random random);

    /** Predictions for an image, the best score first. Safe to call from several threads. */
    [[nodiscard]] std::vector<InstancePrediction> detect(const RenderedView& view,
                                                         const mrpt::math::TPose3D& pose,
                                                         Random random) const;

    /** How well an object can be seen. */
    struct Visibility
    {
        int pixels = 0;   //!< it covers in the image
        float share = 0;  //!< of its surface towards the camera that is in the image
                          //!< and not hidden, in [0,1]
    };
    /** For all objects; id i is at i-1. */
    [[nodiscard]] std::vector<Visibility> visibility(const RenderedView& view,
                                                     const mrpt::math::TPose3D& pose) const;

    /** Probability that an object is detected at all. */
    [[nodiscard]] float detectionProbability(const Visibility& seen) const;

 private:
    class Frame;

    const Scene& m_scene;
    RenderCamera m_camera;
    DetectorOptions m_options;
    Recognition m_recognition;
    std::vector<std::vector<SurfacePoint>> m_surfaces;  //!< sparse points of each object
    std::vector<std::vector<ObjectId>> m_touching;      //!< neighbours of each object
};
}  // namespace voxeland::simulation
