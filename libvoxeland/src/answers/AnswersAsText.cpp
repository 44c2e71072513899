// SPDX-License-Identifier: BSD-3-Clause
#include "AnswersAsText.h"

#include "base/ClassicNumbers.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/printable.h"

#include <mrpt/core/format.h>

#include <algorithm>

namespace voxeland
{
namespace
{
constexpr size_t LIKELIEST = 5;  //!< categories shown of a place

std::string xyz(const mrpt::math::TPoint3D& p)
{
    return format("%.2f, %.2f, %.2f", p.x, p.y, p.z);
}

size_t longestName(const std::vector<FoundInstance>& instances)
{
    size_t longest = std::string("category").size();
    for (const FoundInstance& f : instances)
        longest = std::max(longest, printable(f.summary.category()).size());
    return longest;
}
}  // namespace

std::string asText(const MapOverview& o)
{
    const auto size = o.boxMax - o.boxMin;
    std::string text;
    text += format("resolution     %g m\n", o.resolution);
    text += format("extent         %.2f x %.2f x %.2f m, from (%s) to (%s)\n", size.x, size.y,
                   size.z, xyz(o.boxMin).c_str(), xyz(o.boxMax).c_str());
    text += format("voxels         %zu observed, %zu occupied surface\n", o.observedVoxels,
                   o.occupiedVoxels);
    text += format("memory         %.1f MB; %.1f bytes a free voxel, %.1f a surface voxel\n",
                   static_cast<double>(o.memory.bytes) / 1e6, o.memory.bytesPerFreeVoxel(),
                   o.memory.bytesPerSurfaceVoxel());
    text += format(
        "frames         %u mapped, %u of them without predictions, %u left out without pose\n",
        o.counts.frames, o.counts.framesWithoutPredictions, o.counts.framesWithoutPose);
    text += format("instances      %zu, from %s", o.instances,
                   counted(o.counts.opinions, "opinion").c_str());
    if (o.inactive > 0) text += format("; %zu more count as unknown", o.inactive);
    text += "\n";
    for (const auto& [name, count] : o.categories)
        text += format("               %u %s\n", count, printable(name).c_str());
    return text;
}

std::string asText(const std::vector<FoundInstance>& instances, bool withDistance, bool prior)
{
    const auto width = static_cast<int>(longestName(instances));
    std::string text = withDistance ? "dist [m]    " : "  ";
    text += format("id  %-*s  prob.  entropy  %sobserved  voxels  %-18s  centre [m]\n", width,
                   "category", prior ? "vacuity  " : "", "size [m], yaw [deg]");
    for (const FoundInstance& f : instances) {
        const InstanceSummary& s = f.summary;
        if (withDistance) text += format("%8.2f  ", f.distance);
        text += format("%4u  %-*s  %5.2f  %7.3f  ", s.id, width, printable(s.category()).c_str(),
                       s.probability(), s.entropy);
        if (prior) text += format("%7.3f  ", s.vacuity);
        const std::string size = format("%.2fx%.2fx%.2f %4.0f", f.box.size.x, f.box.size.y,
                                        f.box.size.z, f.box.yaw * 180 / M_PI);
        text += format("%8u  %6u  %-19s  %s\n", s.observations, s.voxels, size.c_str(),
                       xyz(s.centroid).c_str());
    }
    return text;
}

std::string asText(const std::vector<ReobservationTarget>& targets)
{
    if (targets.empty()) return "nothing is worth another look\n";
    std::string text;
    for (const ReobservationTarget& t : targets) {
        const std::string name =
            t.instance ? format("%u %s", *t.instance, printable(t.category).c_str()) : "region";
        text += format("%.3f nat  %s, %s around (%s)\n", t.uncertainty, name.c_str(),
                       counted(t.voxels, "voxel").c_str(), xyz(t.center).c_str());
        for (const CameraPose& p : t.poses)
            text += format(
                "           from (%s), yaw %.0f, pitch %.0f deg: %.1f m away, %.0f %% "
                "visible\n",
                xyz(p.pose.translation()).c_str(), p.yaw * 180 / M_PI, p.pitch * 180 / M_PI,
                p.distance, 100 * p.visible);
        if (t.poses.empty())
            text += "           no free place is known that it is well seen from\n";
    }
    return text;
}

std::string asText(const PlaceAnswer& a)
{
    std::string text = format("voxel centre    %s m\n", xyz(a.center).c_str());
    if (a.nearest)
        text += format("nearest object  %u (%s), %.2f m away\n", a.nearest->id,
                       printable(a.nearest->category).c_str(), a.nearest->distance);
    if (!a.observed && a.instances.empty()) return text + "never observed\n";
    text +=
        format("occupancy       %.3f (%s)\n", a.occupancy, a.occupancy > 0.5 ? "occupied" : "free");
    if (a.instances.empty()) return text + "no surface was ever measured here\n";
    text += "instances\n";
    for (const auto& i : a.instances)
        text += format("  %4u  p %.3f  alpha %8.2f  %s\n", i.id, i.probability, i.alpha,
                       printable(i.category).c_str());
    text += "categories\n";
    const size_t shown = std::min(LIKELIEST, a.categories.size());
    for (size_t i = 0; i < shown; ++i)
        text += format("        p %.3f  %s\n", a.categories[i].probability,
                       printable(a.categories[i].name).c_str());
    if (shown < a.categories.size())
        text += format("        and %s less likely\n",
                       counted(a.categories.size() - shown, "category", "categories").c_str());
    text += format("entropy         instance %.3f, its category %.3f, voxel's category %.3f nat\n",
                   a.instanceEntropy, a.winnerCategoryEntropy, a.categoryEntropy);
    return text;
}
}  // namespace voxeland
