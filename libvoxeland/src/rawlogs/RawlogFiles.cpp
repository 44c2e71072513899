// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogFiles.h"

#include "StagedRawlog.h"
#include "voxeland/base/errors.h"

#include <mrpt/img/CImage.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr auto EXTENSION = ".rawlog";
}  // namespace

RawlogFiles::RawlogFiles(const std::string& file) : rawlog(file)
{
    const std::string stem = fs::path(rawlog).replace_extension().string();
    sidecar = stem + ".instances" + EXTENSION;
    images = stem + "_Images";
}

RawlogFiles RawlogFiles::toRead(const std::string& file)
{
    RawlogFiles files(file);
    try {
        finishReplacing(files);
    } catch (const OutputError& e) {
        throw InputError(e.what());
    }
    return files;
}

void RawlogFiles::useImages() const
{
    const fs::path folder =
        fs::is_directory(images) ? fs::absolute(images) : fs::absolute(rawlog).parent_path();
    mrpt::img::CImage::setImagesPathBase(folder.string());
}
}  // namespace voxeland
