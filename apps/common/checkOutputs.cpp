// SPDX-License-Identifier: BSD-3-Clause
#include "common/checkOutputs.h"

#include "files/OutputPlace.h"
#include "rawlogs/RawlogFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace voxeland::apps
{
namespace
{
/** A path without links; of a file that need not exist. */
fs::path followed(const fs::path& file)
{
    std::error_code error;
    const fs::path path = fs::absolute(file);
    const fs::path place = fs::weakly_canonical(path, error);
    return error ? path.lexically_normal() : place;
}

/** The same of its folder alone: of a link, the link. */
fs::path unfollowed(const fs::path& file)
{
    const fs::path path = fs::absolute(file);
    return followed(path.parent_path()) / path.filename();
}

/** A file or folder that is taken. */
struct Claim
{
    fs::path place;
    bool isWhole = false;  //!< a folder with all that is in it, whatever its name

    [[nodiscard]] bool holds(const Claim& other) const
    {
        const auto [own, others] =
            std::mismatch(place.begin(), place.end(), other.place.begin(), other.place.end());
        return own == place.end() && (isWhole || others == other.place.end());
    }
};

class Claims
{
 public:
    explicit Claims(const NamedFiles& inputs)
    {
        for (const std::string& file : inputs.files) takeInput(file);
        for (const std::string& folder : inputs.folders) takeInput(folder);
        for (const std::string& rawlog : inputs.rawlogs) {
            if (rawlog.empty()) continue;
            const RawlogFiles files(rawlog);
            takeInput(files.rawlog);
            takeInput(files.sidecar);
            takeInput(files.images, true);
            m_rawlogs.push_back(followed(rawlog));
        }
    }

    /** \throws ConfigurationError if something else has claimed it */
    void takeOutput(const std::string& name, const std::vector<Claim>& claims)
    {
        for (const Claim& claim : claims)
            for (const Claim& taken : m_claims)
                if (claim.holds(taken) || taken.holds(claim))
                    throw ConfigurationError(
                        "output '" + name +
                        "' would replace an input or another output, or a part of one: name "
                        "another file");
        m_claims.insert(m_claims.end(), claims.begin(), claims.end());
    }

    [[nodiscard]] bool isInputRawlog(const fs::path& place) const
    {
        return std::find(m_rawlogs.begin(), m_rawlogs.end(), place) != m_rawlogs.end();
    }

 private:
    void takeInput(const fs::path& file, bool isWhole = false)
    {
        if (file.empty()) return;
        m_claims.push_back({followed(file), isWhole});
        m_claims.push_back({unfollowed(file), isWhole});
    }

    std::vector<Claim> m_claims;
    std::vector<fs::path> m_rawlogs;
};
}  // namespace

void checkOutputs(const NamedFiles& outputs, const NamedFiles& inputs)
{
    Claims claims(inputs);
    for (const std::string& file : outputs.files) {
        if (file.empty()) continue;
        const OutputPlace place = outputPlaceOf(file);
        if (!place.isDirect) claims.takeOutput(file, {{place.path}});
        checkWritable(file);
    }
    for (const std::string& rawlog : outputs.rawlogs) {
        if (rawlog.empty()) continue;
        const RawlogFiles files(rawlog);
        const fs::path place = outputPlaceOf(rawlog).path;
        // What lies beside it is replaced as it is: its images may be a link to another rawlog's.
        if (!claims.isInputRawlog(place))
            claims.takeOutput(
                rawlog, {{place}, {unfollowed(files.sidecar)}, {unfollowed(files.images), true}});
    }
    for (const std::string& folder : outputs.folders)
        if (!folder.empty()) claims.takeOutput(folder, {{followed(folder)}});
}
}  // namespace voxeland::apps
