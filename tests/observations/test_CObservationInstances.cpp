// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "voxeland/observations/CObservationInstances.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <sstream>

using namespace voxeland;
using voxeland::test::prediction;
using voxeland::test::rectangleMask;

namespace
{
CObservationInstances twoObjects()
{
    CObservationInstances o =
        *test::makePredictions({prediction(rectangleMask(1, 2, 5, 6), "chair", 0.5F),
                                prediction(rectangleMask(3, 3, 70, 50), "dining table", 0.75F)},
                               123.5);
    o.instances[0].categories = {{"chair", 0.75F}, {"sofa", 0.25F}};
    o.instances[1].track = 42;
    o.sensorPoseOnRobot = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    return o;
}
}  // namespace

TEST(CObservationInstances, ReadsBackWhatWasWritten)
{
    const CObservationInstances written = twoObjects();
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    archive << written;
    stream.Seek(0);
    const auto read = archive.ReadObject<CObservationInstances>();

    EXPECT_EQ(read->timestamp, written.timestamp);
    EXPECT_EQ(read->sensorLabel, "detector");
    EXPECT_EQ(read->imageWidth, test::COLUMNS);
    EXPECT_EQ(read->imageHeight, test::ROWS);
    EXPECT_EQ(read->sensorPoseOnRobot, written.sensorPoseOnRobot);
    ASSERT_EQ(read->instances.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        const auto &a = read->instances[i], &b = written.instances[i];
        EXPECT_EQ(a.mask, b.mask);
        EXPECT_EQ(a.categories, b.categories);
        EXPECT_EQ(a.score, b.score);
        EXPECT_EQ(a.track, b.track);
        EXPECT_EQ(a.box.x, b.box.x);
        EXPECT_EQ(a.box.y, b.box.y);
        EXPECT_EQ(a.box.width, b.box.width);
        EXPECT_EQ(a.box.height, b.box.height);
    }
}

TEST(CObservationInstances, IsKnownToMrptByName)
{
    const auto* id = mrpt::rtti::findRegisteredClass("voxeland::CObservationInstances");
    ASSERT_NE(id, nullptr);
    EXPECT_TRUE(id->derivedFrom(CLASS_ID(mrpt::obs::CObservation)));
}

TEST(CObservationInstances, HasASensorPose)
{
    CObservationInstances o;
    o.setSensorPose(mrpt::poses::CPose3D(1, 2, 3, 0.1, 0.2, 0.3));
    mrpt::poses::CPose3D pose;
    o.getSensorPose(pose);
    EXPECT_NEAR(pose.x(), 1, 1e-12);
    EXPECT_NEAR(pose.yaw(), 0.1, 1e-12);
}

TEST(CObservationInstances, ExportsAndDescribesItself)
{
    const CObservationInstances o = twoObjects();
    EXPECT_TRUE(o.exportTxtSupported());
    std::istringstream header(o.exportTxtHeader()), row(o.exportTxtDataRow());
    size_t instances = 0, pixels = 0;
    row >> instances >> pixels;
    EXPECT_EQ(instances, 2u);
    EXPECT_EQ(pixels, 4u * 4u + 67u * 47u);
    EXPECT_NE(o.exportTxtDataRow().find("dining table:0.75"), std::string::npos);

    std::ostringstream description;
    o.getDescriptionAsText(description);
    for (const char* part : {"2 predicted instances", "80x60", "sofa 0.25", "track 42", "4x4"})
        EXPECT_NE(description.str().find(part), std::string::npos) << part;
}

TEST(Normalized, AddsUpSortsAndScales)
{
    EXPECT_EQ(normalized({{"b", 1}, {"c", 2}, {"a", 1}, {"c", 4}}),
              (CategoryDistribution{{"c", 0.75F}, {"a", 0.125F}, {"b", 0.125F}}));
}

TEST(Normalized, DropsWhatIsNoEvidence)
{
    EXPECT_EQ(normalized({{"a", 0}, {"b", -3}, {"c", NAN}, {"d", INFINITY}, {"e", 0.5F}}),
              (CategoryDistribution{{"e", 1}}));
    EXPECT_TRUE(normalized({}).empty());
    EXPECT_TRUE(normalized({{"a", 0}, {"b", NAN}}).empty());
}
