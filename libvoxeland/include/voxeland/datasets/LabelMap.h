// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <vector>

namespace voxeland
{
struct CsvRow;

/** Number of an evaluation class, from 0; NO_CLASS for what is not evaluated. */
using class_id_t = int;
inline constexpr class_id_t NO_CLASS = -1;

/** Which category names, of the detector and of the ground truth, count as which evaluation class.
 *  Upper and lower case are the same, and so are '_' and a blank. */
class LabelMap
{
 public:
    /** The nine classes of the paper's experiments on SceneNN: the file `paper9.csv` of
     *  `share/labels` as it was when the library was built. */
    static LabelMap paper9();
    /** Reads a CSV file with the header `name,class`. Classes are numbered in order of appearance.
     *  \throws InputError, naming the file, if it is missing, malformed, empty or gives a name to
     *  two classes */
    static LabelMap fromFile(const std::string& file);
    /** The same, from such a file's text. \param source its name, for messages */
    static LabelMap fromText(const std::string& text, const std::string& source);
    /** Whether a table's first row is that of a label map. */
    static bool isHeader(const CsvRow& row);

    /** Where the map comes from: a file name, or "paper9". */
    [[nodiscard]] const std::string& source() const { return m_source; }
    [[nodiscard]] const std::vector<std::string>& classes() const { return m_classes; }
    /** Class of a category name, or NO_CLASS. */
    [[nodiscard]] class_id_t classOf(const std::string& name) const;

 private:
    LabelMap(const std::string& csv, std::string source);

    std::string m_source;
    std::vector<std::string> m_classes;
    std::map<std::string, class_id_t> m_classOf;
};
}  // namespace voxeland
