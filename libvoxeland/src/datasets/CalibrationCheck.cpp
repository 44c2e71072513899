// SPDX-License-Identifier: BSD-3-Clause
#include "CalibrationCheck.h"

#include "FramePairs.h"
#include "observations/Projection.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace voxeland
{
namespace
{
using mrpt::poses::CPose3D;
using Verdict = CalibrationFinding::Verdict;

constexpr std::array<double, 8> DEPTH_SCALES = {1, 100, 256, 1000, 2000, 5000, 6553.5, 10000};
constexpr std::array<double, 8> FOCAL_FACTORS = {0.5, 0.7, 0.8, 0.9, 1.1, 1.25, 1.4, 2};
constexpr double GOOD = 0.03;       // relative disagreement of frames that agree
constexpr double AS_GOOD = 1.5;     // a reading this much worse than another fits as well
constexpr double MIN_SHARE = 0.1;   // of the sampled points that must be comparable
constexpr size_t MIN_POINTS = 100;  // comparable ones

/** Lays the points of one frame into the other. */
class Comparison
{
 public:
    /** \param given the axes that the pairs' poses were read by */
    Comparison(const CalibrationReading& reading, PoseAxes given)
        : m_reading(reading), m_given(given)
    {
    }

    void add(const FramePair& pair)
    {
        const auto& camera = pair.second->cameraParams;
        const CPose3D fromFirst = read(pair.firstPose) - read(pair.secondPose);
        const double f = m_reading.focalFactor;
        m_sampled += pair.first.size();
        for (const SampledPixel& pixel : pair.first) {
            const double depth = pixel.value / m_reading.depthScale;
            const auto p = fromFirst.composePoint(
                {depth * pixel.direction.x / f, depth * pixel.direction.y / f, depth});
            if (p.z > 0) compare(p.z, projected(camera, f * p.x / p.z, f * p.y / p.z), pair);
        }
    }

    /** The reading with what was found. */
    CalibrationReading result()
    {
        const size_t n = m_errors.size();
        m_reading.points = n;
        if (n >= MIN_POINTS && static_cast<double>(n) >= MIN_SHARE * static_cast<double>(m_sampled))
        {
            m_reading.disagreement = median(m_errors);
            m_reading.relative = median(m_relative);
        }
        return m_reading;
    }

 private:
    /** A camera-to-world pose of optical axes as it is if this reading is right. */
    [[nodiscard]] CPose3D read(const CPose3D& optical) const
    {
        if (!m_reading.invertPoses && m_reading.axes == m_given) return optical;
        const CPose3D inSensor = poseOfAxes(PoseAxes::optical);
        CPose3D inFile = optical + -inSensor + poseOfAxes(m_given);
        if (m_reading.invertPoses) inFile = -inFile;
        return inFile + -poseOfAxes(m_reading.axes) + inSensor;
    }

    void compare(double expected, const std::array<double, 2>& pixel, const FramePair& pair)
    {
        const auto& image = pair.second->rangeImage;
        const double column = std::round(pixel[0]), row = std::round(pixel[1]);
        const auto columns = static_cast<double>(image.cols());
        const auto rows = static_cast<double>(image.rows());
        if (!(column >= 0 && row >= 0 && column < columns && row < rows)) return;
        const auto value = image(static_cast<int>(row), static_cast<int>(column));
        if (value == 0) return;
        const double measured = static_cast<double>(value) / m_reading.depthScale;
        m_errors.push_back(std::abs(expected - measured));
        m_relative.push_back(m_errors.back() / measured);
    }

    static double median(std::vector<double>& values)
    {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }

    CalibrationReading m_reading;
    PoseAxes m_given;
    std::vector<double> m_errors, m_relative;
    size_t m_sampled = 0;
};

/** The pairs of a sample, and the axes that their poses were read by. */
struct Sample
{
    const std::vector<FramePair>& pairs;
    PoseAxes axes;
};

CalibrationReading measured(const CalibrationReading& reading, const Sample& sample)
{
    Comparison comparison(reading, sample.axes);
    for (const FramePair& pair : sample.pairs) comparison.add(pair);
    return comparison.result();
}

const CalibrationReading& better(const CalibrationReading& a, const CalibrationReading& b)
{
    return b.relative < a.relative ? b : a;
}

void compareReadings(CalibrationFinding& finding, const Sample& sample)
{
    CalibrationReading inverted = finding.asGiven;
    inverted.invertPoses = true;
    finding.asGiven = measured(finding.asGiven, sample);
    finding.invertedPoses = measured(inverted, sample);
    finding.best = better(finding.asGiven, finding.invertedPoses);
    for (const auto& [name, axes] : poseAxesByName())
        for (CalibrationReading reading : {finding.asGiven, inverted}) {
            if (axes == sample.axes) continue;
            reading.axes = axes;
            finding.otherAxes = better(finding.otherAxes, measured(reading, sample));
        }
    finding.best = better(finding.best, finding.otherAxes);
    for (const double scale : DEPTH_SCALES) {
        if (std::abs(scale / finding.asGiven.depthScale - 1) < 1e-3) continue;
        for (CalibrationReading reading : {finding.asGiven, inverted}) {
            reading = measured({reading.invertPoses, sample.axes, scale}, sample);
            finding.best = better(finding.best, reading);
            if (!reading.invertPoses)
                finding.otherDepthScale = better(finding.otherDepthScale, reading);
        }
    }
    for (const double factor : FOCAL_FACTORS) {
        const auto reading =
            measured({false, sample.axes, finding.asGiven.depthScale, factor}, sample);
        finding.otherFocalLength = better(finding.otherFocalLength, reading);
    }
    finding.best = better(finding.best, finding.otherFocalLength);
}

/** What makes a reading another one than that given. */
std::string difference(const CalibrationReading& reading, const CalibrationReading& given)
{
    std::ostringstream text;
    if (reading.axes != given.axes) text << "poses of " << nameOf(reading.axes) << " axes";
    if (reading.invertPoses) text << (reading.axes != given.axes ? ", inverted" : "inverted poses");
    if (reading.depthScale != given.depthScale) text << "a depth scale of " << reading.depthScale;
    if (reading.focalFactor != 1)
        text << "focal lengths " << reading.focalFactor << " times as long";
    return text.str();
}

/** What is wrong if this reading is right, and what to do. */
std::string remedy(const CalibrationReading& reading, const CalibrationReading& given)
{
    std::ostringstream text;
    if (reading.focalFactor != 1) {
        text << std::setprecision(2) << "the focal lengths should be about " << reading.focalFactor
             << " times as long: give the camera with --intrinsics";
        return text.str();
    }
    const bool scaled = reading.depthScale != given.depthScale;
    if (reading.axes != given.axes)
        text << "the poses are those of " << nameOf(reading.axes)
             << (reading.invertPoses ? " axes and the wrong way round" : " axes")
             << ": use --pose-axes " << nameOf(reading.axes)
             << (reading.invertPoses ? " and add --invert-poses, or leave it out" : "");
    else if (reading.invertPoses)
        text << "the poses are the wrong way round: add --invert-poses, or leave it out";
    // Whole numbers of ten centimetres or more make no depth image.
    constexpr double LEAST_DEPTH_SCALE = 10;
    if (scaled && reading.depthScale < LEAST_DEPTH_SCALE)
        text << (reading.invertPoses ? "; and " : "") << "the poses' places are "
             << given.depthScale / reading.depthScale
             << " times as far apart as depths say: write them in metres";
    else if (scaled)
        text << (reading.invertPoses ? "; and " : "") << "the depth scale is " << reading.depthScale
             << ", not " << given.depthScale << ": use --depth-scale " << reading.depthScale;
    return text.str();
}

void judge(CalibrationFinding& f)
{
    const double given = f.asGiven.relative;
    if (f.best.relative <= GOOD && given > AS_GOOD * f.best.relative) {
        f.verdict = Verdict::contradiction;
        f.sentence = remedy(f.best, f.asGiven);
    } else if (!(given <= GOOD)) {
        f.verdict = Verdict::contradiction;
        f.sentence =
            "the frames do not agree, and neither other depth scales, axes nor inverted poses "
            "explain it:"
            " the intrinsics or the poses are wrong, or things move";
    } else {
        const CalibrationReading& other = better(
            better(better(f.invertedPoses, f.otherAxes), f.otherDepthScale), f.otherFocalLength);
        const bool clear = other.relative > AS_GOOD * given;
        f.verdict = clear ? Verdict::consistent : Verdict::undecided;
        f.sentence = clear ? "depth scale, intrinsics and poses hold together"
                           : "nothing contradicts depth scale, intrinsics and poses, but " +
                                 difference(other, f.asGiven) + " would fit about as well";
    }
}
}  // namespace

CalibrationFinding checkCalibration(const RgbdDatasetReader& dataset,
                                    const std::function<void(size_t read)>& progress)
{
    const auto [pairs, unusable] = pickFramePairs(dataset, progress);
    CalibrationFinding finding;
    finding.unusable = unusable;
    finding.pairs = pairs.size();
    if (!pairs.empty()) {
        finding.asGiven.depthScale = 1 / static_cast<double>(pairs.front().second->rangeUnits);
        finding.asGiven.axes = dataset.poseAxes();
        compareReadings(finding, {pairs, dataset.poseAxes()});
    }
    const bool comparable = std::isfinite(finding.best.relative);
    if (comparable)
        judge(finding);
    else
        finding.sentence =
            "no two of the frames read see the same place from different ones:"
            " nothing can be told";
    return finding;
}
}  // namespace voxeland
