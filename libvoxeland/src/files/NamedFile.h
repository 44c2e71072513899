// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace voxeland
{
/** What becomes of symbolic links that lead out of a folder. */
enum class Links
{
    followed,    //!< the user put them there, as who makes a dataset of another one's images does
    staysInside  //!< refused like any other way out
};

/** Path of a file that another file names, as a list of a dataset or a rawlog does its images: of
 *  somebody else's choice, so it must lie in the folder that it belongs to.
 *  \param name absolute, or relative to the folder
 *  \param namedBy the file that names it, for the message
 *  \param trusted the user vouches for it: it may lie anywhere
 *  \throws InputError, with both names, if it does not, or the name is too long for a file */
std::filesystem::path namedFile(const std::filesystem::path& folder, const std::string& name,
                                const std::string& namedBy, Links links, bool trusted);
}  // namespace voxeland
