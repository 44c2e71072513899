// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland
{
/** Probability that a point which is anywhere in a voxel with equal probability is still in it
 * after an error that is Gaussian and alike in all directions.
 *
 *  Along one axis, an error of t edges leaves the share max(0, 1 - |t|) of a voxel's points in it.
 *  With t ~ N(0, s^2), that is on average
 *
 *      p(s) = erf(1 / (sqrt(2) s)) - sqrt(2 / pi) s (1 - exp(-1 / (2 s^2)))
 *
 *  and p(s)^3 along three axes, with s = displacement / (sqrt(3) edge).
 *  \param displacement root of the mean square of the error's length, >= 0, maybe infinite [m]
 *  \param edge of the voxel, > 0 [m]
 *  \return in (0,1]: 1 without error */
double probabilityOfStaying(double displacement, double edge);
}  // namespace voxeland
