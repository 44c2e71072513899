// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace voxeland
{
/** The files that a run has completed, of several it writes: if one of the others fails, these are
 * whole. */
class WrittenFiles
{
 public:
    /** \param onWritten called with the name of each */
    explicit WrittenFiles(std::function<void(const std::string& file)> onWritten = nullptr)
        : m_onWritten(std::move(onWritten))
    {
    }

    void add(const std::string& file)
    {
        m_names.push_back(file);
        if (m_onWritten) m_onWritten(file);
    }
    /** In the order they were completed. */
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
    /** The end of a sentence on another one that failed: "; complete: map.ply, b.json and 3 more"
     */
    [[nodiscard]] std::string told() const;

 private:
    std::function<void(const std::string&)> m_onWritten;
    std::vector<std::string> m_names;
};
}  // namespace voxeland
