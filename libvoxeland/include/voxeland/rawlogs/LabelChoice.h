// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace voxeland
{
/** Takes the observations of one sensor where several are of a kind: of the label asked for, or
 *  else of the first one met. */
class LabelChoice
{
 public:
    /** \param what the observations, such as "scans" \param wanted label asked for; empty: none
     *  \param key the INI key that asks for one */
    LabelChoice(std::string what, std::string wanted, std::string key);

    /** Whether to take an observation with this label. */
    bool takes(const std::string& label);
    /** Makes a label the one to take, unless another is asked for. */
    void prefer(const std::string& label);
    /** The label taken; empty also as long as none was met. */
    [[nodiscard]] const std::string& label() const { return m_label; }
    /** Adds a sentence on each label left out without being asked. */
    void tell(std::vector<std::string>& notes) const;
    /** Which labels there were instead of the one asked for, in a clause; empty if all were taken.
     */
    [[nodiscard]] std::string othersThanAsked() const;

 private:
    std::string m_what, m_label, m_key;
    bool m_isAsked, m_isChosen;
    std::map<std::string, uint32_t> m_leftOut;  //!< observations of each other label
};
}  // namespace voxeland
