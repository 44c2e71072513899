// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <sys/resource.h>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace
{
constexpr int WIDTH = 64, HEIGHT = 48;

/** Depth at a pixel of the frames below [mm]. */
uint16_t depthAt(int frame, int row, int column)
{
    return static_cast<uint16_t>(1000 + 100 * frame + 3 * row + column);
}

RgbdRecord makeRecord(int frame, bool withInstances = true)
{
    RgbdRecord record;
    record.scan = mrpt::obs::CObservation3DRangeScan::Create();
    auto& scan = *record.scan;
    scan.timestamp = mrpt::Clock::fromDouble(1e9 + frame);
    scan.sensorLabel = "RGBD";
    scan.hasRangeImage = scan.hasIntensityImage = true;
    scan.rangeImage_setSize(HEIGHT, WIDTH);
    for (int r = 0; r < HEIGHT; ++r)
        for (int c = 0; c < WIDTH; ++c) scan.rangeImage(r, c) = depthAt(frame, r, c);
    scan.intensityImage.resize(WIDTH, HEIGHT, mrpt::img::CH_RGB);
    scan.intensityImage.filledRectangle(0, 0, WIDTH - 1, HEIGHT - 1, {200, 100, 50});
    scan.cameraParams.ncols = WIDTH;
    scan.cameraParams.nrows = HEIGHT;
    scan.cameraParams.setIntrinsicParamsFromValues(50, 51, 32, 24);
    scan.cameraParamsIntensity = scan.cameraParams;
    record.robotPose = std::make_shared<mrpt::math::TPose3D>(frame, 2, 3, 0.1, 0.2, 0.3);
    if (!withInstances) return record;
    record.instances = CObservationInstances::Create();
    record.instances->timestamp = scan.timestamp;
    record.instances->sensorLabel = "RGBD";
    record.instances->imageWidth = WIDTH;
    record.instances->imageHeight = HEIGHT;
    return record;
}

void writeRawlog(const std::string& file, const RgbdRawlogWriter::Options& options,
                 bool withInstances = true)
{
    RgbdRawlogWriter writer(file, options);
    for (int i = 0; i < 3; ++i) writer.write(makeRecord(i, withInstances));
    writer.close();
}

std::vector<mrpt::serialization::CSerializable::Ptr> readObjects(const std::string& file)
{
    std::vector<mrpt::serialization::CSerializable::Ptr> objects;
    mrpt::io::CFileGZInputStream in(file);
    auto archive = mrpt::serialization::archiveFrom(in);
    try {
        while (true) objects.push_back(archive.ReadObject());
    } catch (const mrpt::serialization::CExceptionEOF&) {
    }
    return objects;
}

std::vector<std::string> classNames(const std::string& file)
{
    std::vector<std::string> names;
    for (const auto& o : readObjects(file)) names.emplace_back(o->GetRuntimeClass()->className);
    return names;
}

std::vector<std::string> filesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& e : fs::directory_iterator(folder)) names.push_back(e.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

const std::string POSE = "mrpt::obs::CObservationRobotPose",
                  SCAN = "mrpt::obs::CObservation3DRangeScan",
                  INSTANCES = "voxeland::CObservationInstances";

/** Checks the scans of a rawlog against what makeRecord() put in. */
void expectScans(const std::string& file, const std::string& imagesBase)
{
    const std::string before = mrpt::img::CImage::getImagesPathBase();
    mrpt::img::CImage::setImagesPathBase(imagesBase);
    int frame = 0;
    for (const auto& o : readObjects(file)) {
        const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(o);
        if (!scan) continue;
        scan->load();
        ASSERT_EQ(scan->rangeImage.rows(), HEIGHT);
        ASSERT_EQ(scan->rangeImage.cols(), WIDTH);
        for (int r = 0; r < HEIGHT; ++r)
            for (int c = 0; c < WIDTH; ++c) ASSERT_EQ(scan->rangeImage(r, c), depthAt(frame, r, c));
        ASSERT_EQ(scan->intensityImage.getWidth(), static_cast<size_t>(WIDTH));
        EXPECT_NEAR(scan->intensityImage.at<uint8_t>(5, 5, 0), 50, 3) << "blue comes first";
        EXPECT_NEAR(scan->intensityImage.at<uint8_t>(5, 5, 2), 200, 3);
        EXPECT_EQ(scan->cameraParams.ncols, static_cast<uint32_t>(WIDTH));
        EXPECT_EQ(scan->cameraParams.fy(), 51);
        ++frame;
    }
    EXPECT_EQ(frame, 3);
    mrpt::img::CImage::setImagesPathBase(before);
}
}  // namespace

TEST(RgbdRawlogWriter, defaultIsStockRawlogWithSidecarAndImages)
{
    const TemporaryFolder folder;
    writeRawlog(folder.file("k.rawlog"), {});
    EXPECT_EQ(filesIn(folder.path()),
              (std::vector<std::string>{"k.instances.rawlog", "k.rawlog", "k_Images"}));
    EXPECT_EQ(classNames(folder.file("k.rawlog")),
              (std::vector<std::string>{POSE, SCAN, POSE, SCAN, POSE, SCAN}));
    EXPECT_EQ(classNames(folder.file("k.instances.rawlog")),
              (std::vector<std::string>{INSTANCES, INSTANCES, INSTANCES}));
    EXPECT_EQ(
        filesIn(folder.path() / "k_Images"),
        (std::vector<std::string>{
            "3DCAM_RGBD_1000000000.000000_INT.jpg", "3DCAM_RGBD_1000000000.000000_RANGES.bin",
            "3DCAM_RGBD_1000000001.000000_INT.jpg", "3DCAM_RGBD_1000000001.000000_RANGES.bin",
            "3DCAM_RGBD_1000000002.000000_INT.jpg", "3DCAM_RGBD_1000000002.000000_RANGES.bin"}));
    expectScans(folder.file("k.rawlog"), folder.file("k_Images"));
}

TEST(RgbdRawlogWriter, embedsPredictionsAndImages)
{
    const TemporaryFolder folder;
    RgbdRawlogWriter::Options options;
    options.embedImages = options.embedInstances = true;
    options.comment = "made by a test";
    writeRawlog(folder.file("k.rawlog"), options);
    EXPECT_EQ(filesIn(folder.path()), std::vector<std::string>{"k.rawlog"});
    const auto objects = readObjects(folder.file("k.rawlog"));
    ASSERT_EQ(objects.size(), 10U);
    const auto comment = std::dynamic_pointer_cast<mrpt::obs::CObservationComment>(objects[0]);
    ASSERT_TRUE(comment);
    EXPECT_EQ(comment->text, "made by a test");
    expectScans(folder.file("k.rawlog"), "nowhere");
}

TEST(RgbdRawlogWriter, writesActionsAndSensoryFrames)
{
    const TemporaryFolder folder;
    RgbdRawlogWriter::Options options;
    options.embedInstances = options.sensoryFrames = true;
    options.comment = "would be an entry that is no pair";
    RgbdRawlogWriter writer(folder.file("k.rawlog"), options);
    for (int i = 0; i < 3; ++i) {
        RgbdRecord record = makeRecord(i);
        const auto odometry = mrpt::obs::CObservationOdometry::Create();
        odometry->odometry = mrpt::poses::CPose2D(5 + 0.5 * i, 2, 0);
        record.others.push_back(odometry);
        writer.write(record);
    }
    writer.close();

    mrpt::obs::CRawlog rawlog;
    ASSERT_TRUE(rawlog.loadFromRawLogFile(folder.file("k.rawlog")));
    ASSERT_EQ(rawlog.size(), 6U);
    for (size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(rawlog.getType(2 * i), mrpt::obs::CRawlog::etActionCollection);
        ASSERT_EQ(rawlog.getType(2 * i + 1), mrpt::obs::CRawlog::etSensoryFrame);
        const auto movement = rawlog.getAsAction(2 * i)->getBestMovementEstimation();
        EXPECT_NEAR(movement->poseChange->getMeanVal().x(), i == 0 ? 0 : 0.5, 1e-9);
        const auto frame = rawlog.getAsObservations(2 * i + 1);
        ASSERT_EQ(frame->size(), 3U);
        EXPECT_TRUE(frame->getObservationByClass<mrpt::obs::CObservationRobotPose>());
        EXPECT_TRUE(frame->getObservationByClass<mrpt::obs::CObservation3DRangeScan>());
        EXPECT_TRUE(frame->getObservationByClass<CObservationInstances>());
    }
}

TEST(RgbdRawlogWriter, otherSensorsComeFirst)
{
    const TemporaryFolder folder;
    RgbdRawlogWriter writer(folder.file("k.rawlog"), {});
    RgbdRecord record = makeRecord(0, false);
    record.others.push_back(mrpt::obs::CObservationOdometry::Create());
    writer.write(record);
    writer.close();
    EXPECT_EQ(classNames(folder.file("k.rawlog")),
              (std::vector<std::string>{"mrpt::obs::CObservationOdometry", POSE, SCAN}));
}

TEST(RgbdRawlogWriter, partsOfAFrameShareItsTimestamp)
{
    const TemporaryFolder folder;
    RgbdRawlogWriter::Options options;
    options.embedInstances = true;
    writeRawlog(folder.file("k.rawlog"), options);
    const auto objects = readObjects(folder.file("k.rawlog"));
    ASSERT_EQ(objects.size(), 9U);
    for (size_t i = 0; i < objects.size(); ++i) {
        const auto o = std::dynamic_pointer_cast<mrpt::obs::CObservation>(objects[i]);
        EXPECT_EQ(o->timestamp, mrpt::Clock::fromDouble(1e9 + static_cast<double>(i / 3)));
    }
    const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(objects[3]);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->pose.mean.x(), 1);
    EXPECT_NEAR(pose->pose.mean.roll(), 0.3, 1e-12);
}

TEST(RgbdRawlogWriter, leavesNothingWithoutClose)
{
    const TemporaryFolder folder;
    {
        RgbdRawlogWriter writer(folder.file("k.rawlog"), {});
        writer.write(makeRecord(0));
        EXPECT_FALSE(fs::exists(folder.file("k.rawlog")));
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RgbdRawlogWriter, keepsTheOldRawlogUntilClose)
{
    const TemporaryFolder folder;
    writeRawlog(folder.file("k.rawlog"), {});
    const std::string old = test::readFile(folder.file("k.rawlog"));
    {
        RgbdRawlogWriter writer(folder.file("k.rawlog"), {});
        writer.write(makeRecord(7));
    }
    EXPECT_EQ(test::readFile(folder.file("k.rawlog")), old);
    expectScans(folder.file("k.rawlog"), folder.file("k_Images"));
}

TEST(RgbdRawlogWriter, noSidecarOrImagesOfAnEarlierRunSurvive)
{
    const TemporaryFolder folder;
    writeRawlog(folder.file("k.rawlog"), {});
    RgbdRawlogWriter::Options options;
    options.embedImages = true;
    writeRawlog(folder.file("k.rawlog"), options, false);
    EXPECT_EQ(filesIn(folder.path()), std::vector<std::string>{"k.rawlog"});
}

TEST(RgbdRawlogWriter, refusesAFolderThatIsNotItsOwn)
{
    const TemporaryFolder folder;
    fs::create_directory(folder.file("k_Images"));
    EXPECT_THROW(RgbdRawlogWriter(folder.file("k.rawlog"), {}), OutputError);
    EXPECT_TRUE(fs::exists(folder.file("k_Images")));
}

TEST(RgbdRawlogWriter, copiesAnImageFileByteByByte)
{
    const TemporaryFolder folder;
    const std::string jpeg = folder.file("original.jpg");
    RgbdRecord record = makeRecord(0);
    ASSERT_TRUE(record.scan->intensityImage.saveToFile(jpeg, 60));
    record.scan->intensityImage.setExternalStorage(jpeg);
    RgbdRawlogWriter writer(folder.file("k.rawlog"), {});
    writer.write(record);
    writer.close();
    EXPECT_EQ(test::readFile(folder.path() / "k_Images" / "3DCAM_RGBD_1000000000.000000_INT.jpg"),
              test::readFile(jpeg));
}

TEST(RgbdRawlogWriter, embedsThePixelsOfAnImageFile)
{
    const TemporaryFolder folder;
    RgbdRawlogWriter::Options options;
    options.embedImages = true;
    RgbdRawlogWriter writer(folder.file("k.rawlog"), options);
    for (int i = 0; i < 3; ++i) {
        const RgbdRecord record = makeRecord(i);
        const std::string png = folder.file(std::to_string(i) + ".png");
        ASSERT_TRUE(record.scan->intensityImage.saveToFile(png));
        record.scan->intensityImage.setExternalStorage(png);
        writer.write(record);
        fs::remove(png);
    }
    writer.close();
    expectScans(folder.file("k.rawlog"), "nowhere");
}

TEST(RgbdRawlogWriter, restoresTheSettingsOfTheProcess)
{
    const TemporaryFolder folder;
    mrpt::img::CImage::setImagesPathBase("some/where");
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
    writeRawlog(folder.file("external.rawlog"), {});
    RgbdRawlogWriter::Options options;
    options.embedImages = true;
    writeRawlog(folder.file("embedded.rawlog"), options);
    EXPECT_EQ(mrpt::img::CImage::getImagesPathBase(), "some/where");
    EXPECT_TRUE(mrpt::img::CImage::DISABLE_JPEG_COMPRESSION());
    mrpt::img::CImage::setImagesPathBase(".");
}

TEST(RgbdRawlogWriter, saysWhatIsWrongWithTheTarget)
{
    EXPECT_THROW(RgbdRawlogWriter("k.map", {}), ConfigurationError);
    EXPECT_THROW(RgbdRawlogWriter("/no/such/folder/k.rawlog", {}), OutputError);
}

/** Stands for a disk with room for so many bytes a file. */
class FullDisk
{
 public:
    explicit FullDisk(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &m_before);
        m_signal = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_signal);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

 private:
    rlimit m_before{};
    void (*m_signal)(int) = nullptr;
};

TEST(RgbdRawlogWriter, noticesAFullDisk)
{
    for (const bool embedded : {false, true})
        for (const rlim_t room : {0U, 100U, 500U}) {
            const TemporaryFolder folder;
            RgbdRawlogWriter::Options options;
            options.embedImages = embedded;
            const FullDisk disk(room);
            EXPECT_THROW(writeRawlog(folder.file("k.rawlog"), options), OutputError)
                << room << " bytes" << (embedded ? ", embedded" : "");
            EXPECT_TRUE(fs::is_empty(folder.path()));
        }
}

TEST(RgbdRawlogWriter, noticesAFullDiskInTheMiddleOfAFrame)
{
    const TemporaryFolder folder;
    RgbdRecord record = makeRecord(0);
    record.scan->rangeImage_setSize(480, 640);
    std::mt19937 random(1);
    for (int r = 0; r < 480; ++r)
        for (int c = 0; c < 640; ++c)
            record.scan->rangeImage(r, c) = static_cast<uint16_t>(random());
    RgbdRawlogWriter::Options options;
    options.embedImages = true;
    RgbdRawlogWriter writer(folder.file("k.rawlog"), options);
    const FullDisk disk(20000);
    try {
        writer.write(record);
        FAIL() << "no exception";
    } catch (const OutputError& e) {
        EXPECT_EQ(std::string(e.what()),
                  "cannot write " + folder.file("k.rawlog") +
                      ": File too large: allow larger files (ulimit -f) or choose another disk");
    }
}
