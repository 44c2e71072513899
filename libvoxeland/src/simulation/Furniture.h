// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/Scene.h"

#include <mrpt/poses/CPose3D.h>

/** Pieces of furniture and things, made of simple solids. Each function adds one object to a scene
 *  and returns its id. `pose` is the middle of the piece's underside: x points where the piece
 *  faces, y to its left, z up. Sizes vary a little with the random numbers. */
namespace voxeland::simulation::furniture
{
using Pose = mrpt::poses::CPose3D;

/** Outer sizes other pieces are arranged by [m]. */
struct TableSize
{
    float depth = 0.8F, width = 1.4F, height = 0.74F;  //!< along x, y and z
};
constexpr float CHAIR_DEPTH = 0.46F, CHAIR_WIDTH = 0.44F;  //!< along x and y [m]
constexpr float SOFA_DEPTH = 0.88F;                        //!< along x [m]
constexpr float BED_LENGTH = 2.05F;                        //!< along x, the pillow at -x [m]
constexpr float CABINET_DEPTH = 0.42F;                     //!< along x [m]

/** \name What people sit and lie on
 *  @{ */
ObjectId addChair(Scene& scene, const Pose& pose, const Colour& colour);
ObjectId addSofa(Scene& scene, const Pose& pose, float width, const Colour& colour);
ObjectId addBed(Scene& scene, const Pose& pose, float width, Random& random);
ObjectId addToilet(Scene& scene, const Pose& pose);
/** @} */

/** \name What things stand on, or in
 *  @{ */
ObjectId addTable(Scene& scene, const Pose& pose, const TableSize& size, const Colour& colour);
ObjectId addCabinet(Scene& scene, const Pose& pose, float width, float height, float depth,
                    const std::string& category, const Colour& colour);
ObjectId addBookshelf(Scene& scene, const Pose& pose, Random& random);
ObjectId addPlantStand(Scene& scene, const Pose& pose);
ObjectId addRefrigerator(Scene& scene, const Pose& pose, Random& random);
/** @} */

/** \name Things; standsOn is what they rest on
 *  @{ */
ObjectId addTv(Scene& scene, const Pose& pose, float width, ObjectId standsOn, Random& random);
ObjectId addLaptop(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addBooks(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addCup(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addBottle(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addBowl(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addMicrowave(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addBackpack(Scene& scene, const Pose& pose, Random& random);
ObjectId addPottedPlant(Scene& scene, const Pose& pose, ObjectId standsOn, Random& random);
ObjectId addCardboardBox(Scene& scene, const Pose& pose, Random& random);
ObjectId addFloorLamp(Scene& scene, const Pose& pose);
/** Hangs on the wall behind it: pose is the middle of its back. */
ObjectId addPicture(Scene& scene, const Pose& pose, Random& random);
/** @} */
}  // namespace voxeland::simulation::furniture
