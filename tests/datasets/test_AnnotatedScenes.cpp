// SPDX-License-Identifier: BSD-3-Clause
/** Ground truth as ScanNet and SceneNN publish it. */
#include "support/ScanNetScene.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/GroundTruth.h"

#include <gtest/gtest.h>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
template <typename T>
std::string raw(T value)
{
    return std::string(reinterpret_cast<const char*>(&value), sizeof(T));
}

const std::string COLOURED =
    "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\n";

/** Six vertices at (0,0,0), (1,0,0) ... and one triangle, with a last property a vertex. */
std::string mesh(const std::string& lastProperty, const std::vector<std::string>& lastValues)
{
    std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 6\n" + COLOURED +
                      lastProperty +
                      "element face 1\nproperty list uchar int vertex_indices\n"
                      "end_header\n";
    for (size_t i = 0; i < 6; ++i)
        ply += raw(static_cast<float>(i)) + raw(0.0F) + raw(0.0F) + "\x01\x02\x03" + lastValues[i];
    return ply + '\x03' + raw(0) + raw(1) + raw(2);
}

class AnnotatedScenes : public testing::Test
{
 protected:
    void write(const std::string& name, const std::string& content) const
    {
        test::writeFile(m_folder.file(name), content);
    }
    [[nodiscard]] GroundTruth read(const std::string& format) const
    {
        return readGroundTruth(m_folder.path().string(), format);
    }
    void expectFailure(const std::string& format, const std::string& part) const
    {
        try {
            static_cast<void>(read(format));
            FAIL() << "no error about " << part;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
    }
    /** Category name of each point; empty for none. */
    static std::vector<std::string> categories(const GroundTruth& truth)
    {
        std::vector<std::string> names;
        for (size_t i = 0; i < truth.points.size(); ++i)
            names.push_back(truth.instance[i] == 0 ? "" : truth.names[truth.category[i]]);
        return names;
    }
    void writeScanNet() const
    {
        write("scene0001_00_vh_clean_2.ply",
              mesh("property uchar alpha\n", std::vector<std::string>(6, "\xFF")));
        write("scene0001_00_vh_clean_2.0.010000.segs.json",
              R"({"params": {"kThresh": "0.0001"}, "sceneId": "scene0001_00",
                  "segIndices": [10, 10, 20, 30, 40, 50]})");
        write("scene0001_00.aggregation.json",
              R"({"sceneId": "scannet.scene0001_00", "appId": "Aggregator.v2",
                  "segGroups": [
                  {"id": 0, "objectId": 0, "segments": [10, 20], "label": "kitchen table"},
                  {"id": 1, "objectId": 1, "segments": [20], "label": "office chair"},
                  {"id": 2, "objectId": 2, "segments": [30], "label": "wall"},
                  {"id": 3, "objectId": 3, "segments": [40], "label": "blue gnome"}],
                  "segmentsFile": "scannet.scene0001_00_vh_clean_2.0.010000.segs.json"})");
        test::ScanNetScene::writeTable(m_folder.path());
    }
    void writeSceneNN() const
    {
        std::vector<std::string> labels;
        for (const uint32_t label : {0U, 5U, 5U, 6U, 7U, 8U}) labels.push_back(raw(label));
        write("011.ply", mesh("property uint label\n", labels));
        write("011.xml", R"(<?xml version="1.0" encoding="utf-8"?>
            <annotation>
              <label id="5" color="1 2 3" text="chair &amp; cushion" nyu_class="chair"/>
              <label id="6" color="1 2 3" text="" nyu_class="table"/>
              <label id="7" color="1 2 3" text="floor" nyu_class="floor"/>
              <label id="8" color="1 2 3" text="tv" nyu_class="television"
                     aabbox="0 0 0 1 1 1"/>
              <label id="9" text="thing"/>
            </annotation>)");
    }

    test::TemporaryFolder m_folder;
};

using Names = std::vector<std::string>;
}  // namespace

TEST_F(AnnotatedScenes, ScanNetsObjectsAreSegmentsOfTheMesh)
{
    writeScanNet();
    const GroundTruth truth = read("scannet");
    ASSERT_EQ(truth.points.size(), 6U);
    EXPECT_EQ(truth.points[4].x, 4);
    // Segment 20 is claimed twice: the last claim wins. The wall is structure, 50 is of nobody.
    EXPECT_EQ(truth.instance, (std::vector<uint32_t>{1, 1, 2, 0, 4, 0}));
    EXPECT_EQ(categories(truth), (Names{"table", "table", "chair", "", "blue gnome", ""}));
}

TEST_F(AnnotatedScenes, ScanNetsTableMayBeAboveTheScene)
{
    writeScanNet();
    const fs::path scene = m_folder.path() / "scans" / "scene0001_00";
    fs::create_directories(scene);
    for (const auto& entry : fs::directory_iterator(m_folder.path()))
        if (entry.path().filename().string().rfind("scene", 0) == 0)
            fs::rename(entry.path(), scene / entry.path().filename());
    EXPECT_EQ(readGroundTruth(scene.string(), "scannet").names.size(), 3U);
    EXPECT_EQ(
        readGroundTruth((scene / "scene0001_00_vh_clean_2.ply").string(), "scannet").names.size(),
        3U);
}

TEST_F(AnnotatedScenes, ScanNetsFilesMustFitTogether)
{
    expectFailure("scannet", "_vh_clean_2.ply");
    writeScanNet();
    write("scene0001_00_vh_clean_2.0.010000.segs.json", R"({"segIndices": [1, 2]})");
    expectFailure("scannet", "2 segIndices for 6 vertices");
    write("scene0001_00_vh_clean_2.0.010000.segs.json", R"({"segIndices": "none"})");
    expectFailure("scannet", "no list 'segIndices'");
    writeScanNet();
    write("scene0001_00.aggregation.json", R"({"segGroups": [{"objectId": 0}]})");
    expectFailure("scannet", "no list 'segGroups'");
    write("scene0001_00.aggregation.json",
          R"({"segGroups": [], "segmentsFile": "scene0001_00_vh_clean.segs.json"})");
    expectFailure("scannet", "not those of the mesh");
    write("scene0001_00.aggregation.json", R"({"segGroups": [)");
    expectFailure("scannet", "not valid JSON");
    fs::remove(m_folder.file("scene0001_00.aggregation.json"));
    expectFailure("scannet", "scene0001_00.aggregation.json");
    fs::remove(m_folder.file("scannetv2-labels.combined.tsv"));
    expectFailure("scannet", "scannetv2-labels.combined.tsv");
}

TEST_F(AnnotatedScenes, SceneNNsObjectsAreLabelsOfTheVertices)
{
    writeSceneNN();
    const GroundTruth truth = read("scenenn");
    // Label 6 has no text, 7 is structure.
    EXPECT_EQ(truth.instance, (std::vector<uint32_t>{0, 5, 5, 0, 0, 8}));
    EXPECT_EQ(categories(truth), (Names{"", "chair", "chair", "", "", "television"}));
}

TEST_F(AnnotatedScenes, SceneNNsLabelsMayBeOfAnyIntegerType)
{
    writeSceneNN();
    std::vector<std::string> labels;
    for (const int label : {0, 5, 5, 6, 7, 8}) labels.push_back(raw(static_cast<uint16_t>(label)));
    write("011.ply", mesh("property ushort label\n", labels));
    EXPECT_EQ(read("scenenn").instance, (std::vector<uint32_t>{0, 5, 5, 0, 0, 8}));
}

TEST_F(AnnotatedScenes, SceneNNsFilesMustBeWhatTheyAre)
{
    expectFailure("scenenn", "no NNN.ply");
    writeSceneNN();
    write("011.xml", "<annotation><label id=\"1\"");
    expectFailure("scenenn", "valid XML");
    write("011.xml", "<annotation><label id=\"x\" nyu_class=\"bed\"/></annotation>");
    expectFailure("scenenn", "without a number 'id'");
    write("011.xml", "<annotation><label id=\"5\" text=\"bed\"/></annotation>");
    expectFailure("scenenn", "contrib/nyu_class");
    writeSceneNN();
    write("011.ply", mesh("property uchar alpha\n", std::vector<std::string>(6, "\xFF")));
    expectFailure("scenenn", "no vertex property 'label'");
}
