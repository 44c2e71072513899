// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>

namespace voxeland
{
/** What map instances that lie on nothing annotated with an evaluated class are held to be. */
enum class VoidPolicy
{
    ignore,        //!< neither right nor wrong (ScanNet): the ground truth may lack objects
    falsePositive  //!< wrong: the ground truth is complete
};

/** What ranks the map's instances in a precision-recall curve. */
enum class ScoreKind
{
    probability,  //!< p(C_k) of the winning category
    certainty,    //!< 1 - H(C_k) / ln(number of the map's categories), not below 0
    observations  //!< number of opinions
};

/** Choices that a figure of merit depends on. */
struct EvaluationProtocol
{
    size_t minPoints = 100;  //!< smaller instances are left out, smaller objects are ignored
    VoidPolicy voidPolicy = VoidPolicy::ignore;
    ScoreKind score = ScoreKind::probability;
    double matchRadius = 0;  //!< reach of a voxel's centre [m]; 0: automatic, see matchRadius()
};

/** \name Names on the command line and in reports
 *  The inverse functions throw ConfigurationError for any other text. @{ */
std::string toString(VoidPolicy policy);
std::string toString(ScoreKind score);
VoidPolicy voidPolicyFromString(const std::string& name);
ScoreKind scoreKindFromString(const std::string& name);
/** @} */

/** How far a voxel's centre reaches for points that no occupied voxel contains [m]: the protocol's
 *  radius, or max(0.05 m, half the diagonal of a voxel). \param resolution edge of a voxel [m] */
double matchRadius(const EvaluationProtocol& protocol, double resolution);
}  // namespace voxeland
