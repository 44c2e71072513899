// SPDX-License-Identifier: BSD-3-Clause
#include "CEvidentialAssociation.h"

#include "voxeland/base/RegisteredClass.h"

#include <algorithm>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CEvidentialAssociation, voxeland::CAssociationPolicy, voxeland)

namespace
{
using Assignments = std::vector<Assignment>;
using Opinions = std::vector<OpinionOverlaps>;

/** An opinion that could be about an instance. */
struct Match
{
    size_t opinion;
    instance_id_t instance;
    double quality;
};

bool isAssigned(const Assignment& a)
{
    return a.instance != UNKNOWN_INSTANCE;
}

/** Whether an opinion that lies apart was found to be about that instance. */
bool isTaken(const Match& match, const Opinions& opinions, const Assignments& assignments)
{
    for (size_t i = 0; i < opinions.size(); ++i)
        if (assignments[i].instance == match.instance && lieApart(opinions, match.opinion, i))
            return true;
    return false;
}

/** Whether any opinion was found to be about that instance. */
bool isClaimed(instance_id_t instance, const Assignments& assignments)
{
    return std::any_of(assignments.begin(), assignments.end(),
                       [=](const Assignment& a) { return a.instance == instance; });
}

/** Gives opinions that have no instance yet one that they match, the best matches first.
 *  \param isMatch says of an Overlap whether the instance may get the opinion
 *  \param quality says of an Overlap how good it is
 *  \param isFree says of a Match, when its turn comes, whether the instance may still be had */
template <typename IsMatch, typename Quality, typename IsFree>
void assignBest(const Opinions& opinions, IsMatch&& isMatch, Quality&& quality, IsFree&& isFree,
                Assignments& assignments)
{
    std::vector<Match> matches;
    for (size_t i = 0; i < opinions.size(); ++i)
        if (!isAssigned(assignments[i]))
            for (const Overlap& o : opinions[i].candidates)
                if (isMatch(o)) matches.push_back({i, o.instance, quality(o)});
    std::stable_sort(matches.begin(), matches.end(),
                     [](const Match& a, const Match& b) { return a.quality > b.quality; });
    for (const Match& m : matches)
        if (!isAssigned(assignments[m.opinion]) && isFree(m))
            assignments[m.opinion].instance = m.instance;
}
}  // namespace

std::string CEvidentialAssociation::description() const
{
    return "the paper's: overlap with the visible part, relaxed by semantic similarity";
}

void CEvidentialAssociation::declareOptions(OptionList& options)
{
    options.forExperts();
    options.add("tau_iou", m_tauIoU, {0, 1}, "Intersection over union that makes a match");
    options.add("tau_iov_strict", m_tauIoVStrict, {0, 1},
                "Least IoV and IoM of a partial view when categories differ (S_sem = 0)");
    options.add("tau_iov_relaxed", m_tauIoVRelaxed, {0, 1},
                "Least IoV and IoM of a partial view when categories agree (S_sem = 1)");
    options.add("tau_piece", m_tauPiece, {0, 1}, "Least IoM of a piece of an instance");
    options.add("piece_similarity", m_pieceSimilarity, {0, 1},
                "Least semantic similarity of a piece");
    // Matching partial views by what is visible of an instance; letting similarity relax the
    // thresholds (it counts as 0.5 otherwise); one instance for one of the detections of a frame
    // that lie apart; less overlap for instances that no other detection is about.
    options.addAblation({{"iov", m_useIoV, "use_iov"},
                         {"similarity", m_useSimilarity, "use_similarity"},
                         {"exclusive", m_exclusive, "exclusive"},
                         {"unclaimed", m_unclaimed, "unclaimed"}});
}

double CEvidentialAssociation::similarity(double measured) const
{
    return m_useSimilarity ? measured : 0.5;
}

bool CEvidentialAssociation::isMatch(const Overlap& o) const
{
    if (o.intersection == 0) return false;  // the instance is outvoted wherever it was seen
    if (o.iou() >= m_tauIoU) return true;
    if (!m_useIoV) return false;
    const double s = similarity(o.similarity);
    const double tau = m_tauIoVStrict + (m_tauIoVRelaxed - m_tauIoVStrict) * s;
    const bool isVisiblePart = o.iov() >= tau && o.iom() >= tau;
    const bool isPiece = o.iom() >= m_tauPiece && m_useSimilarity && s >= m_pieceSimilarity;
    return isVisiblePart || isPiece;
}

bool CEvidentialAssociation::isMatchUnclaimed(const Overlap& o) const
{
    if (!m_useIoV) return false;
    const bool isVisiblePart = o.iov() >= m_tauIoVRelaxed && o.iom() >= m_tauIoVRelaxed;
    const bool wasSeenHere =
        o.touched() >= m_tauPiece && m_useSimilarity && o.similarity >= m_pieceSimilarity;
    return isVisiblePart || wasSeenHere;
}

double CEvidentialAssociation::quality(const Overlap& o) const
{
    return o.iov() + o.iom() + similarity(o.similarity);
}

std::vector<Assignment> CEvidentialAssociation::associate(
    const std::vector<OpinionOverlaps>& opinions, const SemanticVoxelMap&) const
{
    Assignments assignments(opinions.size());
    for (size_t i = 0; i < opinions.size(); ++i)
        assignments[i].newInstance = static_cast<uint32_t>(i);

    const auto qualityOf = [this](const Overlap& o) { return quality(o); };
    assignBest(
        opinions, [this](const Overlap& o) { return isMatch(o); }, qualityOf,
        [&](const Match& m) { return !(m_exclusive && isTaken(m, opinions, assignments)); },
        assignments);
    if (m_unclaimed)
        assignBest(
            opinions, [this](const Overlap& o) { return isMatchUnclaimed(o); }, qualityOf,
            [&](const Match& m) { return !isClaimed(m.instance, assignments); }, assignments);
    return assignments;
}

bool CEvidentialAssociation::mayMerge(const InstanceOverlap& o, const MergeThresholds& thresholds,
                                      const SemanticVoxelMap&) const
{
    if (o.iou() > thresholds.iou) return true;
    const bool similar = !m_useSimilarity || o.similarity >= thresholds.similarity;
    return thresholds.use_ios && similar && o.ios() >= thresholds.ios;
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CEvidentialAssociation> REGISTERED;
