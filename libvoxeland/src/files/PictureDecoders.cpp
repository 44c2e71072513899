// SPDX-License-Identifier: BSD-3-Clause
/** MRPT and OpenCV leave it to libjpeg and libpng what to do about a damaged picture. By default
 *  libjpeg ends the program, and both print lines of their own. The functions with which users of
 *  these libraries begin are defined here once more, so that this library's definition is found
 *  first: they are those of the libraries with other defaults. */
#include "PictureDecoders.h"

#include "voxeland/base/RefusedMemory.h"

#include <algorithm>
#include <cstdio>
#include <dlfcn.h>
#include <iostream>
#include <new>
#include <stdexcept>

// After <cstdio>, which it needs.
#include <mrpt/img/CImage.h>

#include <jerror.h>
#include <jpeglib.h>
#include <png.h>

namespace
{
constexpr uint64_t MOST_PIXELS = uint64_t{1} << 27;  // a header may promise 4 thousand million

thread_local uint64_t damaged = 0, oversized = 0, mostPixels = MOST_PIXELS;

/** Whether a picture is not to be decoded, by its header. */
bool isOversized(uint64_t columns, uint64_t rows)
{
    if (columns * rows <= mostPixels) return false;
    ++oversized;
    return true;
}

/** The function of this name that would be found without this library. */
template <typename Function>
Function* original(const char* name, Function*)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

[[noreturn]] void throwJpegError(j_common_ptr picture)
{
    const bool isOutOfMemory = picture->err->msg_code == JERR_OUT_OF_MEMORY;
    jpeg_destroy(picture);
    if (isOutOfMemory) voxeland::RefusedMemory::note();
    throw std::runtime_error("a JPEG picture is damaged");
}

void countJpegWarning(j_common_ptr picture)
{
    // Some cameras leave bytes between the parts of a picture, which harm nothing.
    if (picture->err->msg_code != JWRN_EXTRANEOUS_DATA) ++damaged;
}

[[noreturn]] void leavePng(png_structp png, png_const_charp)
{
    png_longjmp(png, 1);
}

void ignorePngWarning(png_structp, png_const_charp) {}
}  // namespace

/** With this MRPT reads the pictures inside rawlogs. One that is no picture is left empty, as what
 *  comes behind it in the file can be read. */
void mrpt::img::CImage::loadFromStreamAsJPEG(mrpt::io::CStream& in)
{
    using Function = void(CImage&, mrpt::io::CStream&);
    static const auto standard =
        original<Function>("_ZN4mrpt3img6CImage20loadFromStreamAsJPEGERNS_2io7CStreamE", nullptr);
    try {
        standard(*this, in);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        *this = CImage();
        ++damaged;
    }
}

extern "C" {
jpeg_error_mgr* jpeg_std_error(jpeg_error_mgr* manager)
{
    static const auto standard = original("jpeg_std_error", &jpeg_std_error);
    standard(manager);
    manager->error_exit = &throwJpegError;
    manager->output_message = &countJpegWarning;
    return manager;
}

boolean jpeg_start_decompress(j_decompress_ptr picture)
{
    static const auto standard = original("jpeg_start_decompress", &jpeg_start_decompress);
    if (isOversized(picture->image_width, picture->image_height)) {
        picture->err->msg_code = JERR_IMAGE_TOO_BIG;
        picture->err->error_exit(reinterpret_cast<j_common_ptr>(picture));
    }
    return standard(picture);
}

png_structp png_create_read_struct(png_const_charp version, png_voidp errorData,
                                   png_error_ptr onError, png_error_ptr onWarning)
{
    static const auto standard = original("png_create_read_struct", &png_create_read_struct);
    return standard(version, errorData, onError != nullptr ? onError : &leavePng,
                    onWarning != nullptr ? onWarning : &ignorePngWarning);
}

void png_read_info(png_structrp png, png_inforp info)
{
    static const auto standard = original("png_read_info", &png_read_info);
    standard(png, info);
    if (isOversized(png_get_image_width(png, info), png_get_image_height(png, info)))
        png_error(png, "too many pixels");
}
}

namespace voxeland
{
uint64_t damagedPictures()
{
    return damaged;
}

uint64_t oversizedPictures()
{
    return oversized;
}

PictureLimit::PictureLimit(uint64_t pixels) : m_before(mostPixels)
{
    mostPixels = std::min(mostPixels, pixels);
}

PictureLimit::~PictureLimit()
{
    mostPixels = m_before;
}

SilentDecoders::SilentDecoders() : m_stderr(std::cerr.rdbuf(nullptr)) {}

SilentDecoders::~SilentDecoders()
{
    std::cerr.rdbuf(m_stderr);
}
}  // namespace voxeland
