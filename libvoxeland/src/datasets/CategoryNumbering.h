// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/CategoryNames.h"

#include <set>
#include <string>

namespace voxeland
{
/** Which names the category numbers of a file of predictions mean. If names are given, they do;
 * else the file's own, and for other numbers COCO's: its 90, or its 80 counted from 0 or from 1
 * where the numbers, or names that the file gives, leave nothing else. */
class CategoryNumbering
{
 public:
    /** \param given by the user \param own the file's, in whatever way \param numbers in the file
     *  \throws InputError if a number has no name, or it is not certain which; without the file's
     *  name */
    CategoryNumbering(const CategoryNames& given, const CategoryNames& own,
                      const std::set<int64_t>& numbers);

    /** \param number one of those of the constructor */
    [[nodiscard]] const std::string& nameOf(int64_t number) const { return m_names.at(number); }
    /** What was found out, for the user; empty if nothing had to be. */
    [[nodiscard]] const std::string& note() const { return m_note; }

 private:
    CategoryNames m_names;
    std::string m_note;
};
}  // namespace voxeland
