// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/RawlogPredictions.h"
#include "files/GzInputFile.h"
#include "files/GzOutputFile.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

using namespace voxeland;
namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;

namespace
{
CObservation3DRangeScan::Ptr makeScan(int frame, const std::string& label = "RGBD")
{
    auto scan = CObservation3DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(1e9 + frame);
    scan->sensorLabel = label;
    scan->sensorPose.z(1.2);
    scan->cameraParams.ncols = scan->cameraParams.nrows = 2;
    return scan;
}

class RawlogPredictionsTest : public testing::Test
{
 protected:
    RawlogPredictionsTest()
    {
        // One chair in frame 0, two in frame 2.
        std::string text;
        for (const int image : {0, 2, 2})
            text += (text.empty() ? "[" : ",") +
                    (R"({"image_id": )" + std::to_string(image) +
                     R"(, "category_id": 62, "segmentation": {"size": [2, 2], "counts": "112"}})");
        test::writeFile(m_folder.file("coco.json"), text + "]");
    }

    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }

    /** Odometry and a scan for each of three frames. */
    void writeObservations(const std::string& secondLabel = "RGBD") const
    {
        GzOutputFile out(path("in.rawlog"));
        for (int i = 0; i < 3; ++i) {
            mrpt::obs::CObservationOdometry odometry;
            odometry.timestamp = makeScan(i)->timestamp;
            out.writeObject(odometry);
            out.writeObject(*makeScan(i, i == 1 ? secondLabel : "RGBD"));
        }
        out.close();
    }

    AddedPredictions add(const std::string& output, bool embed, const std::string& label = "",
                         const std::string& input = "in.rawlog") const
    {
        AddPredictionsOptions options;
        options.embed = embed;
        options.sensorLabel = label;
        const CocoPredictions recorded(path("coco.json"));
        MatchedPredictions matched(recorded, rgbdFramesOf(path(input), label));
        return addPredictions(path(input), recordedPredictions(matched), path(output), options,
                              [](size_t, double) {});
    }

    [[nodiscard]] std::vector<mrpt::serialization::CSerializable::Ptr> read(
        const std::string& name) const
    {
        std::vector<mrpt::serialization::CSerializable::Ptr> objects;
        GzInputFile in(path(name));
        while (const auto o = in.readObject()) objects.push_back(o);
        return objects;
    }

    [[nodiscard]] std::vector<std::string> classes(const std::string& name) const
    {
        std::vector<std::string> names;
        for (const auto& o : read(name)) {
            const std::string full = o->GetRuntimeClass()->className;
            names.push_back(full.substr(full.rfind(':') + 1));
        }
        return names;
    }

    /** Checks the predictions of frames 0, 1 and 2. */
    static void expectInstances(const std::vector<mrpt::serialization::CSerializable::Ptr>& objects)
    {
        int frame = 0;
        for (const auto& o : objects) {
            const auto i = std::dynamic_pointer_cast<CObservationInstances>(o);
            if (!i) continue;
            EXPECT_EQ(i->timestamp, makeScan(frame)->timestamp);
            EXPECT_EQ(i->sensorLabel, "RGBD");
            EXPECT_EQ(i->sensorPoseOnRobot.z, 1.2);
            EXPECT_EQ(i->instances.size(), frame == 0 ? 1U : frame == 1 ? 0U : 2U);
            ++frame;
        }
        EXPECT_EQ(frame, 3);
    }

    test::TemporaryFolder m_folder;
};

using Classes = std::vector<std::string>;
const std::string ODOMETRY = "CObservationOdometry", SCAN = "CObservation3DRangeScan",
                  INSTANCES = "CObservationInstances";
}  // namespace

TEST_F(RawlogPredictionsTest, writesASidecarBesideACopy)
{
    writeObservations();
    const auto added = add("out.rawlog", false);
    EXPECT_EQ(added.frames, 3U);
    EXPECT_EQ(added.predictions, 3U);
    EXPECT_FALSE(added.imagesLinked);
    EXPECT_EQ(test::readFile(path("out.rawlog")), test::readFile(path("in.rawlog")));
    EXPECT_EQ(classes("out.instances.rawlog"), (Classes{INSTANCES, INSTANCES, INSTANCES}));
    expectInstances(read("out.instances.rawlog"));
}

TEST_F(RawlogPredictionsTest, writesASidecarBesideTheInputItself)
{
    writeObservations();
    fs::create_directory(path("in_Images"));
    test::writeFile(path("in_Images/a.jpg"), "image");
    const std::string before = test::readFile(path("in.rawlog"));
    add("in.rawlog", false);
    EXPECT_EQ(test::readFile(path("in.rawlog")), before);
    EXPECT_EQ(test::readFile(path("in_Images/a.jpg")), "image");
    expectInstances(read("in.instances.rawlog"));
}

TEST_F(RawlogPredictionsTest, embedsThemBehindTheirScans)
{
    writeObservations();
    add("out.rawlog", true);
    EXPECT_EQ(classes("out.rawlog"), (Classes{ODOMETRY, SCAN, INSTANCES, ODOMETRY, SCAN, INSTANCES,
                                              ODOMETRY, SCAN, INSTANCES}));
    expectInstances(read("out.rawlog"));
    EXPECT_FALSE(fs::exists(path("out.instances.rawlog")));
}

TEST_F(RawlogPredictionsTest, embeddingAgainReplacesThem)
{
    writeObservations();
    add("out.rawlog", true);
    const std::string once = test::readFile(path("out.rawlog"));
    const auto added = add("out.rawlog", true, "", "out.rawlog");
    EXPECT_EQ(added.replaced, 3U);
    EXPECT_EQ(test::readFile(path("out.rawlog")), once);
    EXPECT_THROW(add("other.rawlog", false, "", "out.rawlog"), InputError);
    EXPECT_FALSE(fs::exists(path("other.rawlog")));
}

TEST_F(RawlogPredictionsTest, fillsSensoryFrames)
{
    {
        GzOutputFile out(path("in.rawlog"));
        for (int i = 0; i < 3; ++i) {
            out.writeObject(mrpt::obs::CActionCollection());
            mrpt::obs::CSensoryFrame frame;
            frame.insert(makeScan(i));
            out.writeObject(frame);
        }
        out.close();
    }
    add("sidecar.rawlog", false);
    expectInstances(read("sidecar.instances.rawlog"));
    add("embedded.rawlog", true);
    std::vector<mrpt::serialization::CSerializable::Ptr> inside;
    for (const auto& o : read("embedded.rawlog"))
        if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(o)) {
            EXPECT_EQ(frame->size(), 2U);
            for (const auto& observation : *frame) inside.push_back(observation);
        }
    EXPECT_EQ(inside.size(), 6U);
    expectInstances(inside);
}

TEST_F(RawlogPredictionsTest, linksTheImages)
{
    writeObservations();
    fs::create_directory(path("in_Images"));
    test::writeFile(path("in_Images/a.jpg"), "image");
    fs::create_directory(path("sub"));
    for (const std::string out : {"out.rawlog", "sub/out.rawlog"}) {
        EXPECT_TRUE(add(out, false).imagesLinked);
        EXPECT_TRUE(add(out, true).imagesLinked) << "again";
    }
    EXPECT_EQ(test::readFile(path("out_Images/a.jpg")), "image");
    EXPECT_EQ(test::readFile(path("sub/out_Images/a.jpg")), "image");
    EXPECT_EQ(test::readFile(path("in_Images/a.jpg")), "image");
}

TEST_F(RawlogPredictionsTest, severalSensorsNeedAChoice)
{
    writeObservations("OTHER");
    EXPECT_THROW(add("out.rawlog", false), ConfigurationError);
    EXPECT_EQ(rgbdFramesOf(path("in.rawlog"), "RGBD").size(), 2U);
    EXPECT_EQ(rgbdFramesOf(path("in.rawlog"), "OTHER").size(), 1U);
    EXPECT_THROW(add("out.rawlog", false, "THIRD"), NothingToMapError);
}

TEST_F(RawlogPredictionsTest, aTruncatedRawlogIsNotCopiedInPart)
{
    writeObservations();
    const std::string whole = test::readFile(path("in.rawlog"));
    test::writeFile(path("in.rawlog"), whole.substr(0, whole.size() * 2 / 3));
    for (const bool embed : {false, true}) EXPECT_THROW(add("out.rawlog", embed), InputError);
    EXPECT_FALSE(fs::exists(path("out.rawlog")));
    EXPECT_FALSE(fs::exists(path("out.instances.rawlog")));
    EXPECT_THROW(add("out.rawlog", false, "", "missing.rawlog"), InputError);
}
