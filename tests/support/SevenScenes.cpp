// SPDX-License-Identifier: BSD-3-Clause
#include "support/SevenScenes.h"

#include "support/TestFiles.h"

#include <opencv2/imgcodecs.hpp>

namespace voxeland::test
{
void writeSevenScenesFrame(const std::filesystem::path& stem, const std::string& extension,
                           int width, int height)
{
    std::filesystem::create_directories(stem.parent_path());
    const std::string name = stem.string();
    cv::imwrite(name + ".color." + extension, cv::Mat(height, width, CV_8UC3, {90, 90, 90}));
    cv::imwrite(name + ".depth.png", cv::Mat(height, width, CV_16U, cv::Scalar(1000)));
    writeFile(name + ".pose.txt", IDENTITY_POSE);
    const auto camera = stem.parent_path().parent_path() / "camera-intrinsics.txt";
    if (width < 640 && !std::filesystem::exists(camera))
        writeFile(camera, "50 0 16\n0 50 12\n0 0 1\n");
}
}  // namespace voxeland::test
