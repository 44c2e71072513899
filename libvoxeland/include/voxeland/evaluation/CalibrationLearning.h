// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/LabelMap.h"
#include "voxeland/evaluation/EvaluatedScene.h"
#include "voxeland/map/Calibration.h"

#include <map>
#include <string>
#include <vector>

namespace voxeland
{
class SemanticVoxelMap;

/** What a detector said of one instance, and what that is. */
struct CalibrationSample
{
    std::map<std::string, double> words;  //!< evidence by word, decisions aside
    /** A word of the detector: that of the truth's name, or else one of the same evaluation class;
     * UNKNOWN_CATEGORY if there is none. */
    std::string truth;
};

/** The instances of a map that stand for an object, see objectsOfInstances(), with what that is.
 *  \param scene the map beside its ground truth
 *  \param labels which names are one class; names of no class must be the same word */
std::vector<CalibrationSample> calibrationSamples(const SemanticVoxelMap& map,
                                                  const EvaluatedScene& scene,
                                                  const LabelMap& labels);

/** Learns what words mean. The meaning of word w is the mean of a Dirichlet distribution: its
 * counts are instances, each as far as its evidence is for w, by what they are; its prior is worth
 * five instances and says what words mean on average: themselves in the share of all evidence that
 * is right, otherwise *unknown* or another word, in the shares of these among what is wrong. So ten
 * objects do no harm. The agreement is the one of a few under which instances of maps that were
 * left out are most likely, 2 being likeliest beforehand.
 *  \param samples of each map; of a single map, every fifth sample is left out in turn
 *  \throws InputError if there are none */
Calibration learnCalibration(const std::vector<std::vector<CalibrationSample>>& samples);
}  // namespace voxeland
