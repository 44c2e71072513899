// SPDX-License-Identifier: BSD-3-Clause
#include "CalibrationCheck.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/printable.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace voxeland
{
namespace
{
constexpr int TITLE_WIDTH = 36;

std::string titled(const std::string& title, double number)
{
    std::ostringstream text;
    text << title << number << ")";
    return text.str();
}

void print(std::ostream& out, const std::string& title, const CalibrationReading& reading)
{
    out << "  " << std::left << std::setw(TITLE_WIDTH) << title;
    if (std::isfinite(reading.disagreement))
        out << std::fixed << std::setprecision(3) << reading.disagreement << " m ("
            << std::setprecision(1) << 100 * reading.relative << " % of the depth)\n";
    else
        out << "surfaces do not meet\n";
}
}  // namespace

std::string CalibrationFinding::text() const
{
    std::ostringstream out;
    for (const auto& [reason, count] : unusable)
        out << "skipped: " << count << " of the frames read, " << printableSentence(reason) << "\n";
    if (verdict != Verdict::nothing) {
        out << "surfaces seen twice: " << counted(pairs, "pair") << " of frames, "
            << counted(asGiven.points, "point") << ", median disagreement\n";
        print(out, titled("as given (depth scale ", asGiven.depthScale), asGiven);
        print(out, "poses inverted", invertedPoses);
        print(out, "best other axes of poses", otherAxes);
        print(out, titled("best other depth scale (", otherDepthScale.depthScale), otherDepthScale);
        print(out, titled("best other focal length (x ", otherFocalLength.focalFactor),
              otherFocalLength);
    }
    out << "verdict: " << printableSentence(sentence, UNCUT) << "\n";
    return out.str();
}
}  // namespace voxeland
