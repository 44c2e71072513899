// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/LeftOut.h"

#include <string>
#include <vector>

namespace voxeland
{
/** A line of a text file that gives times to things: a trajectory or a list of images. */
struct TimedLine
{
    size_t number = 0;  //!< in the file, from 1
    double time = 0;    //!< [s since 1970, or since whatever the file counts from]
    std::string rest;   //!< all behind the time, without the blanks around it
};

/** Text lines `time something`, as TU Munich's RGB-D sequences have them. Blanks, tabs, commas or
 *  semicolons stand behind the time; '#' starts comment lines; a byte order mark, blanks around
 *  lines and ends of lines of other systems are no matter. Columns may have titles, in the first
 *  line or in the last comment before the others. Times too
 *  great for seconds (beyond the year 5000) are milli-, micro- or nanoseconds. */
struct TimedLines
{
    std::string name;                 //!< what the file is and its name, for messages
    std::vector<std::string> titles;  //!< of the columns, the time's first; empty: none are given
    std::vector<TimedLine> lines;     //!< in the file's order
    LeftOut leftOut;                  //!< lines whose time is no number
    std::vector<std::string> notes;   //!< what was assumed: sentences for the user

    /** \param name see above; messages say "line 3 of NAME" \param form what a line should be, such
     *  as "timestamp file" \param strict odd lines are errors
     *  \throws InputError if the file cannot be read, a number has a decimal comma, or no line is
     *  of use */
    static TimedLines fromFile(const std::string& file, const std::string& name,
                               const std::string& form, bool strict = false);

    /** "line 3 of NAME" */
    [[nodiscard]] std::string where(const TimedLine& line) const;
};

/** Words between blanks, tabs, commas and semicolons. */
std::vector<std::string> separatedWords(const std::string& text);
}  // namespace voxeland
