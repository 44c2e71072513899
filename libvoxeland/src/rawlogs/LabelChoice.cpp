// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/LabelChoice.h"

#include "voxeland/base/joined.h"
#include "voxeland/base/printable.h"

namespace voxeland
{
LabelChoice::LabelChoice(std::string what, std::string wanted, std::string key)
    : m_what(std::move(what)),
      m_label(std::move(wanted)),
      m_key(std::move(key)),
      m_isAsked(!m_label.empty()),
      m_isChosen(m_isAsked)
{
}

bool LabelChoice::takes(const std::string& label)
{
    if (!m_isChosen) prefer(label);
    if (label == m_label) return true;
    ++m_leftOut[label];
    return false;
}

void LabelChoice::prefer(const std::string& label)
{
    if (m_isAsked) return;
    m_label = label;
    m_isChosen = true;
}

void LabelChoice::tell(std::vector<std::string>& notes) const
{
    if (m_isAsked) return;
    for (const auto& [label, count] : m_leftOut)
        notes.push_back(std::to_string(count) + " " + m_what + " of '" + label +
                        "' are left out, as those of '" + m_label + "' are used: choose with " +
                        m_key);
}

std::string LabelChoice::othersThanAsked() const
{
    if (!m_isAsked || m_leftOut.empty()) return "";
    std::vector<std::string> labels;
    for (const auto& [label, count] : m_leftOut) labels.push_back("'" + printable(label) + "'");
    return "there are no " + m_what + " of " + m_key + " = " + m_label + ", only of " +
           joined(labels, ", ");
}
}  // namespace voxeland
