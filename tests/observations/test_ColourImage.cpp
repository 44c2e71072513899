// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "support/TestFiles.h"
#include "voxeland/observations/ColourImage.h"
#include "voxeland/observations/UnusableFrame.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgcodecs.hpp>

using namespace voxeland;

namespace
{
class ColourImage : public testing::Test
{
 protected:
    void SetUp() override
    {
        m_scan = test::makeScan([](int, int) { return 1; });
        m_scan->cameraParamsIntensity = m_scan->cameraParams;
        m_scan->hasIntensityImage = true;
        mrpt::img::CImage::setImagesPathBase(m_folder.path().string());
    }
    void TearDown() override { mrpt::img::CImage::setImagesPathBase("."); }

    /** What is wrong with a PNG of so many times the camera's sides. */
    std::string problemOf(int times, int moreColumns)
    {
        const auto& camera = m_scan->cameraParamsIntensity;
        cv::imwrite(m_folder.file("c.png"),
                    cv::Mat(times * static_cast<int>(camera.nrows),
                            times * static_cast<int>(camera.ncols) + moreColumns, CV_8UC3,
                            cv::Scalar(10, 20, 30)));
        return problem();
    }
    [[nodiscard]] std::string problem() const
    {
        m_scan->intensityImage = mrpt::img::CImage();
        m_scan->intensityImage.setExternalStorage("c.png");
        try {
            const cv::Mat image = colourImage(*m_scan);
            return image.at<cv::Vec3b>(1, 1) == cv::Vec3b(10, 20, 30) ? "none" : "other colours";
        } catch (const UnusableFrame& e) {
            return e.what();
        }
    }

    test::TemporaryFolder m_folder;
    mrpt::obs::CObservation3DRangeScan::Ptr m_scan;
};
}  // namespace

TEST_F(ColourImage, isReadFromItsFile)
{
    EXPECT_EQ(problemOf(1, 0), "none");
    EXPECT_EQ(problemOf(4, 0), "none");
    test::writeFile(m_folder.file("c.png"), "no picture");
    EXPECT_NE(problem().find("cannot be read"), std::string::npos) << problem();
    m_scan->hasIntensityImage = false;
    EXPECT_NE(problem().find("has no colour image"), std::string::npos) << problem();
}

TEST_F(ColourImage, isNotDecodedIfItIsFarLargerThanTheCamera)
{
    const std::string told = problemOf(4, 1);
    EXPECT_NE(told.find("too many pixels for its camera"), std::string::npos) << told;
}
