// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/DatasetCameras.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace voxeland
{
/** Sizes in which ScanNet recorded colour and depth. */
inline const std::vector<ImageSize> SCANNET_SIZES = {{1296, 968}, {640, 480}};

/** Layout of a file in ScanNet's `.sens` format, version 4, and access to its frames one at a time.
 */
class SensFile
{
 public:
    /** Where a frame is, and what is known of it without its images. */
    struct Frame
    {
        std::vector<double> cameraToWorld;  //!< 16 numbers, row-major
        uint64_t depthTime = 0;             //!< [us]
        uint64_t at = 0;                    //!< offset of its colour data, which depth follows
        uint64_t colourBytes = 0, depthBytes = 0;
    };

    /** \throws InputError, naming the file, if it cannot be read, is truncated, or something else
     */
    explicit SensFile(const std::string& file);

    [[nodiscard]] const DatasetCameras& cameras() const { return m_cameras; }
    [[nodiscard]] const std::vector<Frame>& frames() const { return m_frames; }
    /** Whether the file says that the cameras are at different places. */
    [[nodiscard]] bool hasExtrinsics() const { return m_hasExtrinsics; }

    /** Colour image of a frame. \throws UnusableFrame if it is damaged */
    [[nodiscard]] cv::Mat colour(size_t index) const;
    /** Depth image of a frame, 16 bit. \throws UnusableFrame if it is damaged */
    [[nodiscard]] cv::Mat depth(size_t index) const;

 private:
    void readHeader(std::istream& in);
    void readFrames(std::istream& in, uint64_t count);
    template <typename T>
    T read(std::istream& in) const;
    std::vector<double> readMatrix(std::istream& in) const;
    PinholeCamera readCamera(std::istream& in);
    [[nodiscard]] std::vector<char> bytesAt(uint64_t offset, uint64_t count) const;
    [[noreturn]] void truncated(const std::string& where) const;

    std::string m_file;
    uint64_t m_size = 0;
    DatasetCameras m_cameras;
    bool m_hasExtrinsics = false;
    int32_t m_colourCompression = 0, m_depthCompression = 0;
    int m_colourWidth = 0, m_colourHeight = 0, m_depthWidth = 0, m_depthHeight = 0;
    std::vector<Frame> m_frames;
};
}  // namespace voxeland
