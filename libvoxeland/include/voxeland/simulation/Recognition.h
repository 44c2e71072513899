// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/Scene.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <string>
#include <vector>

namespace voxeland::simulation
{
/** What a simulated detector takes objects for. Some objects look like something else when seen
 *  from certain directions, always the same ones; what it has no word for gets a wrong name. */
class Recognition
{
 public:
    Recognition(const Scene& scene, const DetectorOptions& options, Random random);

    /** Distribution over category names for an object seen from a point of the world. */
    [[nodiscard]] CategoryDistribution recognize(ObjectId object, const Vector3& from,
                                                 Random& random) const;
    /** The same detection mistaken for another category. */
    [[nodiscard]] CategoryDistribution mistake(ObjectId object, Random& random) const;
    /** Distribution for a detection of nothing. */
    [[nodiscard]] CategoryDistribution imagine(Random& random) const;

    /** The categories the detector knows. */
    static const std::vector<std::string>& vocabulary();

 private:
    /** How one object looks to the detector. */
    struct Look
    {
        std::string name;         //!< what it is mostly taken for
        std::string alternative;  //!< what it is taken for from some directions
        float advantage = 0;      //!< of the name's logit
        float sectorMiddle = 0;   //!< azimuth of these directions [rad]
        bool confused = false;    //!< whether there are such directions
    };

    [[nodiscard]] CategoryDistribution softmax(
        const std::vector<std::pair<std::string, float>>& raised, Random& random) const;

    DetectorOptions m_options;
    std::vector<Look> m_looks;       //!< object id i is at i-1
    std::vector<Vector3> m_centers;  //!< of the objects [m]
};
}  // namespace voxeland::simulation
