// SPDX-License-Identifier: BSD-3-Clause
#include "support/ScanNetScene.h"

#include "support/TestFiles.h"

#include <opencv2/imgcodecs.hpp>

#include <zlib.h>

namespace fs = std::filesystem;

namespace voxeland::test
{
namespace
{
template <typename T>
void append(std::string& bytes, T value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void appendMatrix(std::string& bytes, const std::array<double, 16>& matrix)
{
    for (const double value : matrix) append(bytes, static_cast<float>(value));
}

std::array<double, 16> cameraMatrix(double focal, int width, int height)
{
    return {focal, 0, (width - 1) / 2.0, 0, 0, focal, (height - 1) / 2.0, 0, 0, 0, 1, 0, 0, 0,
            0,     1};
}

constexpr std::array<double, 16> IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}  // namespace

cv::Mat ScanNetScene::depth(int step)
{
    return Room::depth(
        Room::cameraToWorld(step),
        {DEPTH_FOCAL, DEPTH_FOCAL, (DEPTH_WIDTH - 1) / 2.0, (DEPTH_HEIGHT - 1) / 2.0, {}},
        DEPTH_WIDTH, DEPTH_HEIGHT, 1000);
}

ScanNetScene::SensFrame ScanNetScene::sensFrame(int step)
{
    SensFrame frame;
    frame.cameraToWorld = Room::cameraToWorld(step);
    frame.time = 5000000 + 33333 * static_cast<uint64_t>(step);
    std::vector<uint8_t> jpeg;
    cv::imencode(".jpg", greyImage(COLOUR_WIDTH, COLOUR_HEIGHT), jpeg);
    frame.colour.assign(jpeg.begin(), jpeg.end());
    const cv::Mat image = depth(step);
    const uLong size = static_cast<uLong>(image.total() * image.elemSize());
    frame.depth.resize(compressBound(size));
    uLongf length = frame.depth.size();
    compress(reinterpret_cast<Bytef*>(frame.depth.data()), &length, image.data, size);
    frame.depth.resize(length);
    return frame;
}

std::string ScanNetScene::sensFile(const std::vector<SensFrame>& frames, int32_t colourCompression,
                                   int32_t depthCompression, float depthShift)
{
    const std::string sensor = "StructureSensor";
    std::string bytes;
    append(bytes, uint32_t{4});
    append(bytes, static_cast<uint64_t>(sensor.size()));
    bytes += sensor;
    appendMatrix(bytes, cameraMatrix(COLOUR_FOCAL, COLOUR_WIDTH, COLOUR_HEIGHT));
    appendMatrix(bytes, IDENTITY);
    appendMatrix(bytes, cameraMatrix(DEPTH_FOCAL, DEPTH_WIDTH, DEPTH_HEIGHT));
    appendMatrix(bytes, IDENTITY);
    append(bytes, colourCompression);
    append(bytes, depthCompression);
    for (const int pixels : {COLOUR_WIDTH, COLOUR_HEIGHT, DEPTH_WIDTH, DEPTH_HEIGHT})
        append(bytes, static_cast<uint32_t>(pixels));
    append(bytes, depthShift);
    append(bytes, static_cast<uint64_t>(frames.size()));
    for (const SensFrame& frame : frames) {
        appendMatrix(bytes, frame.cameraToWorld);
        append(bytes, frame.time);
        append(bytes, frame.time);
        append(bytes, static_cast<uint64_t>(frame.colour.size()));
        append(bytes, static_cast<uint64_t>(frame.depth.size()));
        bytes += frame.colour + frame.depth;
    }
    append(bytes, uint64_t{0});  // no IMU frames
    return bytes;
}

void ScanNetScene::writeFolder(const fs::path& folder, int frames)
{
    fs::create_directories(folder / "pose");
    fs::create_directories(folder / "intrinsic");
    writeFile(folder / "intrinsic/intrinsic_color.txt",
              matrixText(cameraMatrix(COLOUR_FOCAL, COLOUR_WIDTH, COLOUR_HEIGHT)));
    writeFile(folder / "intrinsic/intrinsic_depth.txt",
              matrixText(cameraMatrix(DEPTH_FOCAL, DEPTH_WIDTH, DEPTH_HEIGHT)));
    for (int i = 0; i < frames; ++i) {
        const std::string number = std::to_string(i);
        writeImage(folder / "color" / (number + ".jpg"), greyImage(COLOUR_WIDTH, COLOUR_HEIGHT));
        writeImage(folder / "depth" / (number + ".png"), depth(i));
        writeFile(folder / "pose" / (number + ".txt"), matrixText(Room::cameraToWorld(i)));
    }
}

void ScanNetScene::writeAnnotation(const fs::path& folder, int frame)
{
    cv::Mat instance(COLOUR_HEIGHT, COLOUR_WIDTH, CV_8U, cv::Scalar(0));
    cv::Mat label(COLOUR_HEIGHT, COLOUR_WIDTH, CV_16U, cv::Scalar(0));
    instance.colRange(0, COLOUR_WIDTH / 2).setTo(1);
    label.colRange(0, COLOUR_WIDTH / 2).setTo(1191);
    label.at<uint16_t>(0, 0) = 1;  // a single pixel says something else
    instance.col(COLOUR_WIDTH - 1).setTo(2);
    label.col(COLOUR_WIDTH - 1).setTo(1);
    const std::string name = std::to_string(frame) + ".png";
    writeImage(folder / "instance-filt" / name, instance);
    writeImage(folder / "label-filt" / name, label);
    writeTable(folder);
}

void ScanNetScene::writeTable(const fs::path& folder)
{
    writeFile(folder / "scannetv2-labels.combined.tsv",
              "id\traw_category\tcategory\tcount\tnyu40id\teigen13id\tnyuClass\tnyu40class\n"
              "1\twall\twall\t8277\t1\t12\twall\twall\n"
              "2\toffice chair\tchair\t4646\t5\t4\tchair\tchair\n"
              "1191\tkitchen table\ttable\t12\t7\t10\ttable\ttable\n"
              "1200\tblue gnome\tgnome\t1\t\t\t\t\n");
}
}  // namespace voxeland::test
