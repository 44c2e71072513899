// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <streambuf>

namespace voxeland
{
/** How many pictures this thread has decoded of which libjpeg says that their bytes are damaged:
 *  parts of them are grey or of wrong colours, or they are left empty. */
uint64_t damagedPictures();

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
