// SPDX-License-Identifier: BSD-3-Clause
#include "TimeAssociation.h"

#include <cmath>
#include <deque>
#include <map>
#include <queue>
#include <tuple>

namespace voxeland
{
namespace
{
/** Places of one time in both lists that have no partner. */
struct Unpaired
{
    std::deque<size_t> first, second;
    [[nodiscard]] bool isEmpty() const { return first.empty() && second.empty(); }
};

/** Of the unpaired, the closest of different times have none in between, so that only neighbours
 * are compared. */
class Association
{
 public:
    Association(const std::vector<double>& first, const std::vector<double>& second, double apart)
        : m_apart(apart), m_partners(first.size(), -1)
    {
        for (size_t i = 0; i < first.size(); ++i) m_times[first[i]].first.push_back(i);
        for (size_t j = 0; j < second.size(); ++j) m_times[second[j]].second.push_back(j);
    }

    std::vector<int64_t> partners()
    {
        for (auto at = m_times.begin(); at != m_times.end();) {
            while (!at->second.first.empty() && !at->second.second.empty())
                pair(at->second, at->second);
            at = at->second.isEmpty() ? m_times.erase(at) : std::next(at);
        }
        for (auto at = m_times.begin(); at != m_times.end(); ++at) propose(at);
        while (!m_proposals.empty()) {
            const Proposal best = m_proposals.top();
            m_proposals.pop();
            const auto first = m_times.find(best.firstTime), second = m_times.find(best.secondTime);
            if (first == m_times.end() || second == m_times.end() || first->second.first.empty() ||
                first->second.first.front() != best.first || second->second.second.empty() ||
                second->second.second.front() != best.second)
                continue;  // one of them has a partner by now
            pair(first->second, second->second);
            for (const auto at : {first, second}) {
                propose(at);
                if (at != m_times.begin()) propose(std::prev(at));
            }
            for (const auto at : {first, second}) remove(at);
        }
        return m_partners;
    }

 private:
    using Times = std::map<double, Unpaired>;

    struct Proposal
    {
        double apart;
        size_t first, second;
        double firstTime, secondTime;
        bool operator<(const Proposal& other) const  // the best is the last
        {
            return std::tie(apart, first, second) >
                   std::tie(other.apart, other.first, other.second);
        }
    };

    void pair(Unpaired& a, Unpaired& b)
    {
        m_partners[a.first.front()] = static_cast<int64_t>(b.second.front());
        a.first.pop_front();
        b.second.pop_front();
    }

    /** Proposes to pair those of a time with those of the next one. */
    void propose(Times::iterator at)
    {
        const auto next = std::next(at);
        if (next == m_times.end()) return;
        const bool isFirst = !at->second.first.empty();
        const auto& [firstTime, first] = isFirst ? *at : *next;
        const auto& [secondTime, second] = isFirst ? *next : *at;
        if (first.first.empty() || second.second.empty() || secondTime < firstTime - m_apart ||
            secondTime > firstTime + m_apart)
            return;
        m_proposals.push({std::abs(secondTime - firstTime), first.first.front(),
                          second.second.front(), firstTime, secondTime});
    }

    /** Takes a time away if all of it have partners: its neighbours are each other's then. */
    void remove(Times::iterator at)
    {
        if (!at->second.isEmpty()) return;
        const auto next = m_times.erase(at);
        if (next != m_times.begin()) propose(std::prev(next));
    }

    double m_apart;
    Times m_times;
    std::priority_queue<Proposal> m_proposals;
    std::vector<int64_t> m_partners;
};
}  // namespace

std::vector<int64_t> associateTimes(const std::vector<double>& first,
                                    const std::vector<double>& second, double apart)
{
    return Association(first, second, apart).partners();
}
}  // namespace voxeland
