// SPDX-License-Identifier: BSD-3-Clause
/** The network converter: on a real network and real frames, and on models that cannot be used. */
#include "SmallOnnx.h"
#include "datasets/MatchedPredictions.h"
#include "support/ConfiguredPlugin.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/RgbdDatasetReader.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/core/version.hpp>

#include <cmath>

using namespace voxeland;
using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
fs::path realNetwork()
{
    return redkitchen().parent_path() / "models" / "yolov8n-seg.onnx";
}

std::shared_ptr<COpinionConverter> converter(const std::string& keys)
{
    return configuredPlugin<COpinionConverter>("dnn", "CDnnConverter", keys);
}

std::shared_ptr<COpinionConverter> realConverter(const std::string& keys = "")
{
    return converter("model = " + realNetwork().string() + "\n" + keys);
}

double intersectionOverUnion(const RunLengthMask& a, const RunLengthMask& b)
{
    const auto pixelsA = a.toBitmap(), pixelsB = b.toBitmap();
    size_t common = 0, all = 0;
    for (size_t i = 0; i < pixelsA.size(); ++i) {
        common += pixelsA[i] & pixelsB[i];
        all += pixelsA[i] | pixelsB[i];
    }
    return static_cast<double>(common) / static_cast<double>(all);
}

float probabilityOf(const InstancePrediction& p, const std::string& category)
{
    for (const auto& c : p.categories)
        if (c.name == category) return c.probability;
    return 0;
}

/** Both come with the best score first. */
void expectSame(const std::vector<InstancePrediction>& found,
                const std::vector<InstancePrediction>& expected, int64_t frame)
{
    ASSERT_EQ(found.size(), expected.size()) << "frame " << frame;
    for (size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE("frame " + std::to_string(frame) + ", detection " + std::to_string(i));
        EXPECT_NEAR(found[i].score, expected[i].score, 0.001);
        EXPECT_GE(intersectionOverUnion(found[i].mask, expected[i].mask), 0.98);
        EXPECT_NEAR(found[i].box.x, expected[i].box.x, 1);
        EXPECT_NEAR(found[i].box.height, expected[i].box.height, 2);
        for (const auto& c : expected[i].categories)
            EXPECT_NEAR(probabilityOf(found[i], c.name), c.probability, 0.001) << c.name;
    }
}

mrpt::obs::CObservation3DRangeScan::Ptr frameOfKitchen(int64_t number)
{
    const auto reader = openDataset("7scenes", redkitchen().string());
    reader->select(number, number, 1);
    RgbdRecord record;
    EXPECT_TRUE(reader->next(record));
    return record.scan;
}

/** What is said about a model, or other settings, that cannot be used. */
template <typename Error>
std::string errorOf(const std::string& keys)
{
    testing::internal::CaptureStderr();
    std::string message = "no error";
    try {
        converter(keys);
    } catch (const Error& e) {
        message = e.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
}

class SmallModels : public testing::Test
{
 protected:
    /** The key that names a model of this content. */
    [[nodiscard]] std::string model(const std::string& content) const
    {
        const std::string file = m_folder.file("model.onnx");
        writeFile(file, content);
        return "model = " + file + "\n";
    }
    TemporaryFolder m_folder;
};

#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
}  // namespace

TEST(DnnConverter, aRealNetworkSeesWhatWasRecordedOfIt)
{
    SKIP_WITHOUT_REDKITCHEN();
    constexpr size_t EVERY = 10;
    const CocoPredictions file((redkitchen() / "predictions_coco.json").string());
    const auto network = realConverter("top_classes = 5\n");
    const auto reader = openDataset("7scenes", redkitchen().string());
    MatchedPredictions recorded(file, reader->frames());
    reader->select(0, std::numeric_limits<int64_t>::max(), EVERY);
    size_t detections = 0;
    for (RgbdRecord record; reader->next(record);) {
        const auto found = network->predict(*record.scan);
        EXPECT_EQ(found->imageWidth, 640);
        EXPECT_EQ(found->imageHeight, 480);
        detections += found->instances.size();
        expectSame(found->instances, recorded.instancesFor(reader->position(), 640, 480)->instances,
                   reader->frame().number);
    }
    EXPECT_EQ(detections, 102u);
}

TEST(DnnConverter, givesTheWholeDistributionUnlessAskedForLess)
{
    SKIP_WITHOUT_REDKITCHEN();
    const auto scan = frameOfKitchen(0);
    const auto all = realConverter()->predict(*scan)->instances;
    const auto two = realConverter("top_classes = 2\n")->predict(*scan)->instances;
    ASSERT_EQ(all.size(), two.size());
    ASSERT_FALSE(all.empty());
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].categories.size(), 80u);
        ASSERT_EQ(two[i].categories.size(), 2u);
        float sum = 0;
        for (const auto& c : all[i].categories) sum += c.probability;
        EXPECT_NEAR(sum, 1, 1e-5);
        EXPECT_NEAR(two[i].categories[0].probability / two[i].categories[1].probability,
                    all[i].categories[0].probability / all[i].categories[1].probability, 1e-3);
    }
}

TEST(DnnConverter, usesTheClassesThatAreAllowed)
{
    SKIP_WITHOUT_REDKITCHEN();
    const auto found =
        realConverter("classes = cup , chair\n")->predict(*frameOfKitchen(0))->instances;
    EXPECT_EQ(found.size(), 3u);  // of four, without the table
    for (const auto& p : found)
        EXPECT_TRUE(p.categories[0].name == "cup" || p.categories[0].name == "chair");
    EXPECT_HAS(errorOf<ConfigurationError>("model = " + realNetwork().string() +
                                           "\nclasses = dinning table\n"),
               "did you mean 'dining table'?");
}

TEST(DnnConverter, aFrameWithoutColourImageIsNamed)
{
    SKIP_WITHOUT_REDKITCHEN();
    mrpt::obs::CObservation3DRangeScan scan;
    scan.sensorLabel = "RGBD";
    try {
        realConverter()->predict(scan);
        FAIL();
    } catch (const InputError& e) {
        EXPECT_HAS(std::string(e.what()), "'RGBD'");
        EXPECT_HAS(std::string(e.what()), "no colour image");
    }
}

TEST(DnnConverter, settingsThatDoNotFitTheModelAreNamed)
{
    SKIP_WITHOUT_REDKITCHEN();
    const TemporaryFolder folder;
    writeFile(folder.file("names"), "cup\nchair\n");
    const std::string model = "model = " + realNetwork().string() + "\n";
    EXPECT_HAS(errorOf<ConfigurationError>(model + "labels = " + folder.file("names") + "\n"),
               "names 2 classes but the network tells 80 apart");
    EXPECT_HAS(errorOf<ConfigurationError>(model + "input_width = 320\n"), "640x640 only");
    EXPECT_HAS(errorOf<InputError>(model + "layout = yolov5\n"),
               "output0 1x116x8400, output1 1x32x160x160, which is not the layout named");
    EXPECT_HAS(errorOf<InputError>(model + "layout = mask_rcnn\n"), "detection_out_final");
    EXPECT_HAS(errorOf<ConfigurationError>(model + "backend = vulkan\n"),
               "backend = vulkan with target = cpu");
}

TEST(DnnConverter, aRealModelThatIsCutOffIsNamed)
{
    SKIP_WITHOUT_REDKITCHEN();
    const TemporaryFolder folder;
    writeFile(folder.file("cut.onnx"), readFile(realNetwork()).substr(0, 3'000'000));
    EXPECT_HAS(errorOf<InputError>("model = " + folder.file("cut.onnx") + "\n"),
               "cut.onnx' is cut off");
}

TEST_F(SmallModels, anOperationThatOpenCVLacksIsNamed)
{
    const OnnxNode relu = {"Relu", {"x"}, {"z"}};
    const auto unknown = smallOnnx({relu, {"Frobnicate", {"z"}, {"y"}}}, {1, 3, 32, 32});
    EXPECT_HAS(errorOf<InputError>(model(unknown)), "has an operation 'Frobnicate' that OpenCV");
    EXPECT_HAS(errorOf<InputError>(model(unknown)), "export it anew with opset=12 simplify=True");
    const auto dynamic = smallOnnx({relu, {"TopK", {"z"}, {"y"}}}, {0, 3, 32, 32});
    EXPECT_HAS(errorOf<InputError>(model(dynamic)),
               "export it anew with nms=False end2end=False dynamic=False opset=12");
    // OpenCV 4.6 cannot repeat a constant along another axis than the channels.
    if (CV_VERSION_MAJOR > 4 || CV_VERSION_MINOR > 6) return;
    const auto broadcast =
        smallOnnx({relu, {"Mul", {"z", "c"}, {"y"}}}, {1, 3, 32, 32}, "", {{1, 1, 1, 32}});
    EXPECT_HAS(errorOf<InputError>(model(broadcast)), "cannot do the operation 'Mul_node' (");
}

TEST_F(SmallModels, aNetworkOfAnotherKindIsToldWithItsShapes)
{
    const auto relu = [](const std::vector<int>& shape) {
        return smallOnnx({{"Relu", {"x"}, {"y"}}}, shape);
    };
    EXPECT_HAS(errorOf<InputError>(model(relu({1, 3, 32, 64}))), "y 1x3x32x64");
    EXPECT_HAS(errorOf<InputError>(model(relu({1, 3, 0, 0}))), "y 1x3x640x640");
    EXPECT_HAS(
        errorOf<InputError>(model(relu({1, 3, 0, 0})) + "input_width = 320\ninput_height = 160\n"),
        "y 1x3x160x320");
}

TEST_F(SmallModels, aModelThatIsMissingOrNoneIsNamed)
{
    EXPECT_HAS(errorOf<ConfigurationError>(""), "model is empty");
    EXPECT_HAS(errorOf<InputError>("model = " + m_folder.file("no.onnx") + "\n"),
               "there is no model");
    EXPECT_HAS(errorOf<InputError>(model("<html>not found</html>")), "is not an ONNX model");
    writeFile(m_folder.file("yolov8n-seg.pt"), "weights");
    EXPECT_HAS(errorOf<InputError>("model = " + m_folder.file("yolov8n-seg.pt") + "\n"),
               "yolo export model=yolov8n-seg.pt format=onnx");
    writeFile(m_folder.file("graph.pb"), "some text");
    EXPECT_HAS(errorOf<InputError>("model = " + m_folder.file("graph.pb") + "\n"), "graph.pb");
}
