// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/EvaluationProtocol.h"

#include "voxeland/base/errors.h"

#include <algorithm>
#include <cmath>

namespace voxeland
{
std::string toString(VoidPolicy policy)
{
    return policy == VoidPolicy::ignore ? "ignore" : "fp";
}

std::string toString(ScoreKind score)
{
    switch (score) {
        case ScoreKind::certainty:
            return "certainty";
        case ScoreKind::observations:
            return "observations";
        default:
            return "probability";
    }
}

VoidPolicy voidPolicyFromString(const std::string& name)
{
    for (const VoidPolicy p : {VoidPolicy::ignore, VoidPolicy::falsePositive})
        if (name == toString(p)) return p;
    throw ConfigurationError("the void policy '" + name + "' is not one of ignore, fp.");
}

ScoreKind scoreKindFromString(const std::string& name)
{
    for (const ScoreKind s :
         {ScoreKind::probability, ScoreKind::certainty, ScoreKind::observations})
        if (name == toString(s)) return s;
    throw ConfigurationError("the score '" + name +
                             "' is not one of probability, certainty, observations.");
}

double matchRadius(const EvaluationProtocol& protocol, double resolution)
{
    if (protocol.matchRadius > 0) return protocol.matchRadius;
    return std::max(0.05, std::sqrt(3.0) / 2 * resolution);
}
}  // namespace voxeland
