// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/math/TPoint3D.h>

#include <array>
#include <memory>

namespace mrpt::poses
{
class CPose3D;
}

namespace voxeland
{
/** Covariance of a pose's x, y, z [m] and yaw, pitch, roll [rad], in this order, as that of MRPT's
 *  CPose3DPDFGaussian; null: none is known, and the pose counts as exact. */
using PoseCovariance = std::shared_ptr<const mrpt::math::CMatrixDouble66>;

/** How far the uncertainty of a pose displaces what is seen from there, to first order.
 *
 *  A small error (dt, dw) of the pose, dw being a rotation vector, moves a point at u from the
 * pose's origin by dt + dw x u. Its mean square is
 *
 *      d^2(u) = tr(Stt) + 2 u . E[dt x dw] + |u|^2 tr(Sww) - u' Sww u
 *
 *  where Stt, Sww and Stw are blocks of the covariance of (dt, dw), and E[dt x dw] is made of
 *  differences of elements of Stw. dw = A (dyaw, dpitch, droll), the columns of A being the axes
 * these angles turn about: z, the robot's y axis before it pitches, and its x axis. */
class PoseUncertainty
{
 public:
    /** \param pose the most probable one
     *  \throws InputError if the covariance has elements that are not numbers, or negative ones on
     *  its diagonal */
    PoseUncertainty(const mrpt::poses::CPose3D& pose,
                    const mrpt::math::CMatrixDouble66& covariance);

    /** Root of the mean square displacement of a point [m]; infinite where it is beyond all
     * numbers. \param point in the map's frame */
    [[nodiscard]] double displacement(const mrpt::math::TPoint3D& point) const;

 private:
    mrpt::math::TPoint3D m_origin;
    double m_translation = 0;                         //!< tr(Stt) [m^2]
    mrpt::math::TVector3D m_mixed;                    //!< E[dt x dw] [m rad]
    std::array<mrpt::math::TVector3D, 3> m_rotation;  //!< rows of tr(Sww) I - Sww [rad^2]
};
}  // namespace voxeland
