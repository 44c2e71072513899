// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/RawlogFiles.h"

#include "voxeland/errors.h"

#include <mrpt/img/CImage.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr auto EXTENSION = ".rawlog";

RawlogFiles partOf(const RawlogFiles& target)
{
    RawlogFiles part = target;
    for (auto* path : {&part.rawlog, &part.sidecar, &part.images}) *path += ".part";
    return part;
}
}  // namespace

RawlogFiles::RawlogFiles(const std::string& file) : rawlog(file)
{
    const std::string stem = fs::path(rawlog).replace_extension().string();
    sidecar = stem + ".instances" + EXTENSION;
    images = stem + "_Images";
}

void RawlogFiles::useImages() const
{
    const fs::path folder =
        fs::is_directory(images) ? fs::absolute(images) : fs::absolute(rawlog).parent_path();
    mrpt::img::CImage::setImagesPathBase(folder.string());
}

StagedRawlog::StagedRawlog(const std::string& file) : m_target(file), m_part(partOf(m_target))
{
    if (m_target.rawlog.extension() != EXTENSION)
        throw ConfigurationError("the name of the rawlog " + file + " must end in " + EXTENSION);
    if (!fs::exists(m_target.rawlog) && fs::exists(m_target.images))
        throw OutputError("the folder " + m_target.images.string() +
                          " is in the way of the images of " + file +
                          ": remove it or choose another name");
    discard();
}

StagedRawlog::~StagedRawlog()
{
    discard();
}

void StagedRawlog::discard() const
{
    std::error_code ignored;
    for (const auto& path : {m_part.rawlog, m_part.sidecar, m_part.images})
        fs::remove_all(path, ignored);
}

void StagedRawlog::putInPlace()
{
    try {
        fs::remove(m_target.sidecar);
        if (!m_keepImages) fs::remove_all(m_target.images);
        const auto place = [](const fs::path& part, const fs::path& target) {
            if (fs::exists(fs::symlink_status(part))) fs::rename(part, target);
        };
        place(m_part.images, m_target.images);
        place(m_part.sidecar, m_target.sidecar);
        place(m_part.rawlog, m_target.rawlog);
    } catch (const fs::filesystem_error& e) {
        throw OutputError("cannot replace " + m_target.rawlog.string() + ": " + e.code().message());
    }
}
}  // namespace voxeland
