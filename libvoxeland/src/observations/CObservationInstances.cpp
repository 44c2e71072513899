// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/CObservationInstances.h"

#include "base/Reading.h"
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/base/counted.h"

#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

namespace voxeland
{
CategoryDistribution normalized(CategoryDistribution scores)
{
    std::map<std::string, double> byName;
    double sum = 0;
    for (const auto& s : scores) {
        if (!(s.probability > 0) || !std::isfinite(s.probability)) continue;
        byName[s.name] += static_cast<double>(s.probability);
        sum += static_cast<double>(s.probability);
    }
    CategoryDistribution result;
    for (const auto& [name, score] : byName)
        result.push_back({name, static_cast<float>(score / sum)});
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });
    return result;
}

IMPLEMENTS_SERIALIZABLE(CObservationInstances, mrpt::obs::CObservation, voxeland)
const RegisteredClass<CObservationInstances> REGISTERED;

void CObservationInstances::getSensorPose(mrpt::poses::CPose3D& out) const
{
    out = mrpt::poses::CPose3D(sensorPoseOnRobot);
}

void CObservationInstances::setSensorPose(const mrpt::poses::CPose3D& pose)
{
    sensorPoseOnRobot = pose.asTPose();
}

uint8_t CObservationInstances::serializeGetVersion() const
{
    return 0;
}

void CObservationInstances::serializeTo(mrpt::serialization::CArchive& out) const
{
    out << timestamp << sensorLabel << sensorPoseOnRobot << imageWidth << imageHeight;
    out << static_cast<uint32_t>(instances.size());
    for (const auto& i : instances) {
        out << i.mask.runs() << i.score << i.box.x << i.box.y << i.box.width << i.box.height
            << i.track << static_cast<uint32_t>(i.categories.size());
        for (const auto& c : i.categories) out << c.name << c.probability;
    }
}

void CObservationInstances::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
    if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
    in >> timestamp;
    sensorLabel = readText(in);
    in >> sensorPoseOnRobot >> imageWidth >> imageHeight;
    instances.clear();
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        InstancePrediction i;
        auto runs = readValues<std::vector<uint32_t>>(in, RunLengthMask::MOST_PIXELS + 1);
        in >> i.score >> i.box.x >> i.box.y >> i.box.width >> i.box.height >> i.track;
        i.mask = RunLengthMask(imageWidth, imageHeight, std::move(runs));
        for (auto c = in.ReadAs<uint32_t>(); c > 0; --c) {
            CategoryProbability category;
            category.name = readText(in);
            in >> category.probability;
            i.categories.push_back(std::move(category));
        }
        instances.push_back(std::move(i));
    }
}

void CObservationInstances::getDescriptionAsText(std::ostream& o) const
{
    CObservation::getDescriptionAsText(o);
    o << counted(instances.size(), "predicted instance") << " in an image of " << imageWidth << "x"
      << imageHeight << " pixels\n";
    for (const auto& i : instances) {
        o << "  score " << i.score << ", " << i.mask.area() << " pixels, box (" << i.box.x << ","
          << i.box.y << ") " << i.box.width << "x" << i.box.height;
        if (i.track != InstancePrediction::NO_TRACK) o << ", track " << i.track;
        o << ":";
        for (const auto& c : i.categories) o << " " << c.name << " " << c.probability << ";";
        o << "\n";
    }
}

std::string CObservationInstances::exportTxtHeader() const
{
    return "instances pixels categories_with_scores";
}

std::string CObservationInstances::exportTxtDataRow() const
{
    uint64_t pixels = 0;
    std::string names;
    for (const auto& i : instances) {
        pixels += i.mask.area();
        names += names.empty() ? "" : ",";
        names += i.categories.empty() ? "?" : i.categories.front().name;
        names += ":" + std::to_string(i.score);
    }
    return std::to_string(instances.size()) + " " + std::to_string(pixels) + " " + names;
}
}  // namespace voxeland
