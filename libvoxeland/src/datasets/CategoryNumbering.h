// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/CategoryNames.h"

#include <map>
#include <string>

namespace voxeland
{
/** Category numbers as a file of predictions uses them. */
struct CategoryNumbers
{
    std::map<int64_t, size_t> uses;  //!< in how many predictions each is
    size_t predictions = 0;          //!< in the file
    bool ofNamedImages = false;      //!< image ids are names without ending, as Ultralytics writes
};

/** Which names the category numbers of a file of predictions mean. If names are given, they do;
 *  else the file's own, and for other numbers COCO's: its 90, or its 80 counted from 0 or from 1
 *  where that leaves fewer predictions without a name, or as few and more of them are of things
 * found in rooms; 80 come first for the files of Ultralytics. A tenth of the predictions may have
 * numbers without a name. */
class CategoryNumbering
{
 public:
    /** \param given by the user \param own the file's, in whatever way
     *  \throws InputError if too many predictions have no name, or it is not certain which; without
     *  the file's name */
    CategoryNumbering(const CategoryNames& given, const CategoryNames& own,
                      const CategoryNumbers& numbers);

    /** \throws std::invalid_argument if it has none */
    [[nodiscard]] const std::string& nameOf(int64_t number) const;
    /** What was found out, for the user; empty if nothing had to be. */
    [[nodiscard]] const std::string& note() const { return m_note; }
    /** What the numbers may mean as well, for the user; empty if nothing. */
    [[nodiscard]] const std::string& doubt() const { return m_doubt; }

 private:
    void checkGiven(const CategoryNames& given, const CategoryNumbers& numbers);
    void addCocos(const CategoryNames& own, const CategoryNumbers& numbers);

    CategoryNames m_names;
    std::string m_note, m_doubt;
};
}  // namespace voxeland
