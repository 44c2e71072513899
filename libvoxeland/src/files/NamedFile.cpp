// SPDX-License-Identifier: BSD-3-Clause
#include "NamedFile.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** Whether a path begins with that of a folder; both absolute and without `..`. */
bool beginsWith(const fs::path& path, fs::path folder)
{
    if (!folder.has_filename()) folder = folder.parent_path();  // "folder/"
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

bool isInside(const fs::path& folder, const fs::path& name, Links links)
{
    const fs::path file = folder / name;
    std::error_code error;
    if (links == Links::staysInside) {
        const fs::path place = fs::weakly_canonical(file, error);
        return !error && beginsWith(place, fs::weakly_canonical(folder));
    }
    // What "link/.." is, the text does not tell: no way up is taken, even if it is one back.
    return std::find(name.begin(), name.end(), "..") == name.end() &&
           beginsWith(fs::absolute(file).lexically_normal(),
                      fs::absolute(folder).lexically_normal());
}
}  // namespace

fs::path namedFile(const fs::path& folder, const std::string& name, const std::string& namedBy,
                   Links links, bool trusted)
{
    std::error_code error;
    static_cast<void>(fs::symlink_status(folder / name, error));
    if (error == std::errc::filename_too_long)
        throw InputError("'" + namedBy + "' names '" + printable(name) +
                         "', which is too long for the name of a file: make '" + namedBy +
                         "' anew");
    if (trusted || isInside(folder, name, links)) return folder / name;
    const bool isLink = isInside(folder, name, Links::followed);
    throw InputError("'" + namedBy + "' names '" + printable(name) +
                     (isLink ? "', which is a link out of '" : "', which is not in '") +
                     folder.string() + "': if that is right, say --trust-paths");
}
}  // namespace voxeland
