// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <streambuf>

namespace voxeland
{
/** How many pictures this thread has decoded of which libjpeg says that their bytes are damaged:
 *  parts of them are grey or of wrong colours, or they are left empty. */
uint64_t damagedPictures();

/** How many PNG and JPEG pictures this thread has not decoded since their headers promise more
 * pixels than a PictureLimit, or 134 million. */
uint64_t oversizedPictures();

/** While it lives this thread decodes no PNG or JPEG picture of more pixels: a file of a few kB may
 *  promise any number of them. */
class PictureLimit
{
 public:
    explicit PictureLimit(uint64_t pixels);
    ~PictureLimit();
    PictureLimit(const PictureLimit&) = delete;
    PictureLimit& operator=(const PictureLimit&) = delete;

 private:
    uint64_t m_before;
};

/** Keeps OpenCV from telling on stderr in its own words why a picture cannot be decoded; nothing
 *  else gets there either while it lives. */
class SilentDecoders
{
 public:
    SilentDecoders();
    ~SilentDecoders();
    SilentDecoders(const SilentDecoders&) = delete;
    SilentDecoders& operator=(const SilentDecoders&) = delete;

 private:
    std::streambuf* m_stderr;
};
}  // namespace voxeland
