// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/CocoPredictions.h"

#include "CocoReader.h"
#include "voxeland/files/Json.h"

namespace voxeland
{
CocoPredictions::CocoPredictions(const std::string& file, const CategoryNames& names, bool strict)
    : m_file(file), m_isStrict(strict), m_leftOut(strict)
{
    CocoReader(*this, names).read(readJsonOrLines(file));
}

size_t CocoPredictions::count() const
{
    size_t n = 0;
    for (const Image& image : m_images) n += image.entries.size();
    return n;
}
}  // namespace voxeland
