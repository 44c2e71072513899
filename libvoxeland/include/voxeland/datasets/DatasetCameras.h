// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>
#include <vector>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** Size of an image [pixels]. */
struct ImageSize
{
    int width = 0, height = 0;

    [[nodiscard]] bool operator==(const ImageSize& o) const
    {
        return width == o.width && height == o.height;
    }
    [[nodiscard]] bool operator<(const ImageSize& o) const
    {
        return width != o.width ? width < o.width : height < o.height;
    }
    /** "640x480" */
    [[nodiscard]] std::string text() const;
};

/** Pinhole camera [pixels], with lens distortion by the plumb-bob model of OpenCV and MRPT. */
struct PinholeCamera
{
    double fx = 0, fy = 0, cx = 0, cy = 0;
    std::array<double, 5> distortion{};  //!< k1 k2 p1 p2 k3
    ImageSize size{};                    //!< of its images; 0x0: not known
};

/** What depth scales there are, for messages. Depth images have 16 bits: of another scale all
 * depths would be beyond any room, or nearer than any camera sees. */
constexpr auto DEPTH_SCALES = "depth images are in metres (1) to micrometres (1000000)";
[[nodiscard]] inline bool isDepthScale(double scale)
{
    return scale >= 1 && scale <= 1e6;
}

/** What a dataset says of the two cameras that took its frames, both at the same place. */
struct DatasetCameras
{
    PinholeCamera depth, colour;
    bool registered = true;    //!< both images show the same, pixel by pixel
    double depthScale = 1000;  //!< numbers in a depth image that make a metre, see isDepthScale()
    /** Sizes the dataset's images have as they were recorded: where a camera's size is not known
     *  and its centre is the middle of one of these, it is that. */
    std::vector<ImageSize> recordedSizes{};
};

/** Cameras with registered images. */
DatasetCameras registeredCameras(const PinholeCamera& camera, double depthScale,
                                 const std::vector<ImageSize>& recordedSizes = {});

/** The camera of images that may have been resized since it was calibrated: scaled, if the size it
 *  belongs to is known, or told by its centre and one of the recorded sizes.
 *  \param which images, for messages, e.g. "the depth images"
 *  \param option the option that gives the camera, e.g. "--intrinsics"
 *  \param notes receives what was done, if anything
 *  \throws InputError if the camera belongs to images of another shape, or of another size that
 *  cannot be told */
PinholeCamera fittedCamera(const PinholeCamera& camera, const ImageSize& images,
                           const std::vector<ImageSize>& recordedSizes, const std::string& which,
                           const std::string& option, std::vector<std::string>& notes);

/** Calibrates a scan whose images are loaded. Its depth camera is at the robot's origin.
 *  \throws InputError if the centre of a camera is not in its image */
void calibrate(mrpt::obs::CObservation3DRangeScan& scan, const DatasetCameras& cameras);
}  // namespace voxeland
