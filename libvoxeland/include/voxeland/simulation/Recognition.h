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
 *  from certain directions, always the same ones; what it has no word for gets wrong names, others
 * from other sides. */
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
        /** What it is taken for: its name, or, where the detector has no word for it, the names
         *  it gets from one side to the other. */
        std::vector<std::string> names;
        std::string alternative;  //!< what it is confused with from some directions
        float advantage = 0;      //!< of the name's logit
        float front = 0;          //!< azimuth it is mostly seen from [rad]
        float sectorMiddle = 0;   //!< azimuth of the directions of confusion [rad]
        bool confused = false;    //!< whether there are such directions
    };

    /** The name an object goes by, seen from an azimuth [rad]. */
    [[nodiscard]] static const std::string& nameFrom(const Look& look, float azimuth);
    [[nodiscard]] CategoryDistribution softmax(
        const std::vector<std::pair<std::string, float>>& raised, Random& random) const;

    DetectorOptions m_options;
    std::vector<Look> m_looks;       //!< object id i is at i-1
    std::vector<Vector3> m_centers;  //!< of the objects [m]
};
}  // namespace voxeland::simulation
