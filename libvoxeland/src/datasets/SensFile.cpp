// SPDX-License-Identifier: BSD-3-Clause
#include "SensFile.h"

#include "ImageFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/UnusableFrame.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <zlib.h>

namespace voxeland
{
namespace
{
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, ".sens files are little-endian");

constexpr uint32_t VERSION = 4;
constexpr uint64_t LONGEST_NAME = 10000;
constexpr uint64_t FRAME_HEADER = 96;      // bytes: a pose, two times and two sizes
constexpr uint32_t LARGEST_IMAGE = 32768;  // pixels a side

enum Compression : int32_t
{
    RAW = 0,
    PNG_COLOUR = 1,
    ZLIB_DEPTH = 1,
    JPEG_COLOUR = 2
};

bool isIdentity(const std::vector<double>& m)
{
    for (size_t i = 0; i < m.size(); ++i)
        if (!(std::abs(m[i] - (i % 5 == 0 ? 1 : 0)) < 1e-6)) return false;
    return true;
}
}  // namespace

SensFile::SensFile(const std::string& file) : m_file(file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in || !std::filesystem::is_regular_file(file)) throw InputError("cannot read " + file);
    m_size = std::filesystem::file_size(file);
    readHeader(in);
    readFrames(in, read<uint64_t>(in));
}

template <typename T>
T SensFile::read(std::istream& in) const
{
    T value{};
    if (!in.read(reinterpret_cast<char*>(&value), sizeof(T))) truncated("its header");
    return value;
}

std::vector<double> SensFile::readMatrix(std::istream& in) const
{
    std::vector<double> matrix(16);
    for (double& value : matrix) value = static_cast<double>(read<float>(in));
    return matrix;
}

PinholeCamera SensFile::readCamera(std::istream& in)
{
    const auto k = readMatrix(in);
    m_hasExtrinsics = !isIdentity(readMatrix(in)) || m_hasExtrinsics;
    if (!(k[0] > 0 && k[5] > 0 && std::isfinite(k[0] + k[5])))
        throw InputError(m_file + " has no valid camera intrinsics");
    return {k[0], k[5], k[2], k[6], {}};
}

void SensFile::readHeader(std::istream& in)
{
    const auto version = read<uint32_t>(in);
    if (version != VERSION)
        throw InputError(m_file + " is not a .sens file of version 4 (it begins with " +
                         std::to_string(version) + ")");
    const auto nameLength = read<uint64_t>(in);
    if (nameLength > LONGEST_NAME) throw InputError(m_file + " is damaged: so long a sensor name");
    in.ignore(static_cast<std::streamsize>(nameLength));
    m_cameras.registered = false;
    m_cameras.recordedSizes = SCANNET_SIZES;
    m_cameras.colour = readCamera(in);
    m_cameras.depth = readCamera(in);
    m_colourCompression = read<int32_t>(in);
    m_depthCompression = read<int32_t>(in);
    for (int* size : {&m_colourWidth, &m_colourHeight, &m_depthWidth, &m_depthHeight}) {
        const auto pixels = read<uint32_t>(in);
        if (pixels == 0 || pixels > LARGEST_IMAGE)
            throw InputError(m_file + " is damaged: images of " + std::to_string(pixels) +
                             " pixels a side");
        *size = static_cast<int>(pixels);
    }
    m_cameras.depthScale = static_cast<double>(read<float>(in));
    if (!(m_cameras.depthScale > 0 && std::isfinite(m_cameras.depthScale)))
        throw InputError(m_file + " has no valid depth scale");
    if (m_colourCompression < RAW || m_colourCompression > JPEG_COLOUR)
        throw InputError(m_file + " has colour images of compression " +
                         std::to_string(m_colourCompression) + "; only 0 to 2 can be read");
    if (m_depthCompression != RAW && m_depthCompression != ZLIB_DEPTH)
        throw InputError(m_file + " has depth images of compression " +
                         std::to_string(m_depthCompression) + "; only 0 and 1 can be read");
}

void SensFile::readFrames(std::istream& in, uint64_t count)
{
    for (uint64_t i = 0; i < count; ++i) {
        const std::string where = "frame " + std::to_string(i) + " of " + std::to_string(count);
        if (m_size - static_cast<uint64_t>(in.tellg()) < FRAME_HEADER) truncated(where);
        Frame frame;
        frame.cameraToWorld = readMatrix(in);
        read<uint64_t>(in);  // time of colour
        frame.depthTime = read<uint64_t>(in);
        frame.colourBytes = read<uint64_t>(in);
        frame.depthBytes = read<uint64_t>(in);
        frame.at = static_cast<uint64_t>(in.tellg());
        const uint64_t left = m_size - frame.at;
        if (frame.colourBytes > left || frame.depthBytes > left - frame.colourBytes)
            truncated(where);
        in.seekg(static_cast<std::streamoff>(frame.colourBytes + frame.depthBytes), std::ios::cur);
        m_frames.push_back(std::move(frame));
    }
}

cv::Mat SensFile::colour(size_t index) const
{
    const Frame& frame = m_frames[index];
    const auto bytes = bytesAt(frame.at, frame.colourBytes);
    cv::Mat image(m_colourHeight, m_colourWidth, CV_8UC3);
    if (m_colourCompression != RAW) {
        image = decodeImage(bytes, "colour image");
    } else {
        if (bytes.size() != image.total() * image.elemSize())
            throw UnusableFrame("colour image is of another size than the header says");
        std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(image.data));
        cv::cvtColor(image, image, cv::COLOR_RGB2BGR);
    }
    if (image.cols != m_colourWidth || image.rows != m_colourHeight)
        throw UnusableFrame("colour image is of another size than the header says");
    return image;
}

cv::Mat SensFile::depth(size_t index) const
{
    const Frame& frame = m_frames[index];
    const auto bytes = bytesAt(frame.at + frame.colourBytes, frame.depthBytes);
    cv::Mat image(m_depthHeight, m_depthWidth, CV_16U);
    const size_t expected = image.total() * image.elemSize();
    bool whole = bytes.size() == expected;
    if (m_depthCompression == ZLIB_DEPTH) {
        uLongf length = expected;
        whole = uncompress(image.data, &length, reinterpret_cast<const Bytef*>(bytes.data()),
                           bytes.size()) == Z_OK &&
                length == expected;
    } else if (whole) {
        std::memcpy(image.data, bytes.data(), expected);
    }
    if (!whole) throw UnusableFrame("depth image is damaged or of another size");
    return image;
}

std::vector<char> SensFile::bytesAt(uint64_t offset, uint64_t count) const
{
    std::ifstream in(m_file, std::ios::binary);
    std::vector<char> bytes(count);
    in.seekg(static_cast<std::streamoff>(offset));
    if (!in.read(bytes.data(), static_cast<std::streamsize>(count)))
        throw InputError("cannot read " + m_file);
    return bytes;
}

void SensFile::truncated(const std::string& where) const
{
    throw InputError(m_file + " is truncated: it ends within " + where);
}
}  // namespace voxeland
