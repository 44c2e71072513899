// SPDX-License-Identifier: BSD-3-Clause
#include "report/MapReport.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/system/string_utils.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstring>

using namespace voxeland;
using nlohmann::json;
using voxeland::test::TemporaryFolder;

namespace
{
std::string report(const SemanticVoxelMap& map, const ReportOptions& options = ReportOptions(),
                   const ThreeLibrary& three = {"/* core */", "/* controls */"})
{
    return reportAsHtml(map, MappingCounts(), options, three);
}

/** The data element of a page. */
json dataOf(const std::string& page)
{
    const std::string start = "<script id=\"data\" type=\"application/json\">";
    const size_t begin = page.find(start) + start.size();
    return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

template <typename T>
std::vector<T> decoded(const json& base64)
{
    std::vector<uint8_t> bytes;
    EXPECT_TRUE(mrpt::system::decodeBase64(base64, bytes));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

size_t count(const std::string& text, const std::string& part)
{
    size_t n = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}
}  // namespace

TEST(MapReport, isOneFileThatLoadsNothing)
{
    const std::string page = report(test::tinyMap());
    EXPECT_EQ(page.find("{{"), std::string::npos) << "every place is filled";
    for (const char* part : {"src=\"", "href=", "@import", "url(", "fetch(", "http:"})
        EXPECT_EQ(count(page, part), 0U) << part;
    EXPECT_EQ(count(page, "/* core */"), 1U);
    EXPECT_EQ(count(page, "/* controls */"), 1U);
}

TEST(MapReport, holdsTheVoxels)
{
    const json data = dataOf(report(test::tinyMap()));
    ASSERT_EQ(data["voxels"], 3);
    EXPECT_EQ(data["origin"], (json{-1, -1, -1}));
    const auto positions = decoded<uint16_t>(data["positions"]);
    const auto owners = decoded<uint32_t>(data["owners"]);
    const auto doubts = decoded<uint8_t>(data["doubts"]);
    ASSERT_EQ(positions.size(), 9U);
    ASSERT_EQ(owners.size(), 3U);
    ASSERT_EQ(doubts.size(), 3U);
    EXPECT_NEAR(data["scale"].get<double>(), test::H_CATEGORY_2_2, 1e-9) << "the largest of all";
    std::map<std::vector<uint16_t>, size_t> at;
    for (size_t i = 0; i < 3; ++i)
        at[{positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}] = i;
    const auto ownerAt = [&](std::vector<uint16_t> place) -> int {
        const uint32_t owner = owners[at.at(place)];
        return owner == 0 ? 0 : data["instances"][owner - 1]["id"].get<int>();
    };
    EXPECT_EQ(ownerAt({0, 0, 0}), 0);
    EXPECT_EQ(ownerAt({1, 1, 1}), 1);
    EXPECT_EQ(ownerAt({2, 1, 1}), 2);
    EXPECT_EQ(doubts[at.at({0, 0, 0})], 0);
    EXPECT_NEAR(doubts[at.at({2, 1, 1})], 255 * test::H_INSTANCE_1_1 / test::H_CATEGORY_2_2, 1);
}

TEST(MapReport, holdsTheInstances)
{
    const json data = dataOf(report(test::tinyMap()));
    ASSERT_EQ(data["instances"].size(), 2U);
    const json& cup = data["instances"][0];
    EXPECT_EQ(cup["category"], "cup");
    EXPECT_EQ(cup["probabilities"][0], (json{"cup", 1.0}));
    EXPECT_EQ(cup["observations"], 3);
    EXPECT_EQ(data["pictures"].size(), 10U);
    EXPECT_EQ(dataOf(report(SemanticVoxelMap()))["voxels"], 0);
}

TEST(MapReport, levelsTheWorld)
{
    ReportOptions options;
    options.up = {0, -1, 0};
    EXPECT_EQ(dataOf(report(test::tinyMap(), options))["axes"][2], (json{0.0, -1.0, 0.0}));
}

TEST(MapReport, namesCannotBreakThePage)
{
    SemanticVoxelMap map = test::tinyMap();
    const std::string name = "</script><b> & <!--";
    test::addVoxel(map, {3, 3, 3}, {{test::addInstance(map, {{name, 1}}), 5}});
    ReportOptions options;
    options.title = name;
    const std::string page = report(map, options, {"x = '</script>';", ""});
    EXPECT_EQ(count(page, "</script>"), count(page, "<script"));
    EXPECT_NE(page.find("<title>&lt;/script>&lt;b> &amp; &lt;!--</title>"), std::string::npos);
    const json data = dataOf(page);
    EXPECT_EQ(data["title"], name);
    const json& all = data["instances"];
    EXPECT_TRUE(
        std::any_of(all.begin(), all.end(), [&](const json& i) { return i["category"] == name; }));
}

TEST(MapReport, aMissingLibraryIsNamed)
{
    try {
        ThreeLibrary::fromFolder("/no/such/folder");
        FAIL();
    } catch (const ConfigurationError& e) {
        EXPECT_NE(std::string(e.what()).find("/no/such/folder/three.min.js"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("libjs-three"), std::string::npos);
    }
}

/** The page in a real browser, with software WebGL. */
class MapReportInBrowser : public testing::Test
{
 protected:
    void SetUp() override
    {
        if (test::runProgram("chromium", {"--version"}).exitCode != 0)
            GTEST_SKIP() << "there is no program chromium";
        if (!std::filesystem::exists(std::string(THREE_FOLDER) + "/three.min.js"))
            GTEST_SKIP() << "the package libjs-three is not installed";
    }

    /** Runs the browser on a page. \param script run after the page's own */
    [[nodiscard]] test::ProgramResult browse(std::vector<std::string> options,
                                             const std::string& script = "") const
    {
        std::string page = report(room(), ReportOptions(), ThreeLibrary::fromFolder());
        page.insert(page.rfind("</body>"), "<script>" + script + "</script>");
        test::writeFile(m_folder.file("report.html"), page);
        const std::vector<std::string> common = {"--headless",
                                                 "--no-sandbox",
                                                 "--use-angle=swiftshader",
                                                 "--enable-unsafe-swiftshader",
                                                 "--user-data-dir=" + m_folder.file("profile"),
                                                 "--window-size=1400,900",
                                                 "--virtual-time-budget=5000"};
        options.insert(options.begin(), common.begin(), common.end());
        options.push_back("file://" + m_folder.file("report.html"));
        return test::runProgram("chromium", options);
    }

    /** A grey floor with a chair and a table on it. */
    static SemanticVoxelMap room()
    {
        SemanticVoxelMap map;
        const auto chair = test::addInstance(map, {{"chair", 9}});
        const auto table = test::addInstance(map, {{"table", 5}, {"bed", 4}});
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x) {
                test::addVoxel(map, {x, y, 0}, {{UNKNOWN_INSTANCE, 1}});
                if (y < 10 || y >= 30) continue;
                if (x >= 5 && x < 15) test::addVoxel(map, {x, y, 9}, {{chair, 3}});
                if (x >= 30 && x < 55) test::addVoxel(map, {x, y, 14}, {{table, 3}});
            }
        return map;
    }

    TemporaryFolder m_folder;
};

TEST_F(MapReportInBrowser, drawsTheObjects)
{
    const auto result = browse({"--screenshot=" + m_folder.file("page.png")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const cv::Mat3b image = cv::imread(m_folder.file("page.png"));
    ASSERT_FALSE(image.empty());
    // In the left half, right of the legend and below the buttons, there is the 3D view only.
    int colourful = 0, grey = 0;
    for (int row = 150; row < image.rows - 50; ++row)
        for (int column = 150; column < image.cols / 2; ++column) {
            const cv::Vec3b& c = image(row, column);
            const int low = std::min({c[0], c[1], c[2]}), high = std::max({c[0], c[1], c[2]});
            if (high - low > 60)
                ++colourful;
            else if (high < 250)
                ++grey;
        }
    EXPECT_GT(colourful, 10000) << "the objects";
    EXPECT_GT(grey, 5000) << "the floor";
}

TEST_F(MapReportInBrowser, pointingChoosingAndColouring)
{
    const auto result = browse({"--dump-dom"}, R"(
        const label = document.querySelector('#labels span').getBoundingClientRect();
        canvas.dispatchEvent(new PointerEvent('pointermove', {
            clientX: label.left + label.width / 2, clientY: label.top + label.height / 2}));
        document.body.dataset.tip = element('tip').textContent;
        element('filter').value = 'CHAIR';
        element('filter').dispatchEvent(new Event('input'));
        document.body.dataset.rows = element('table').tBodies[0].rows.length;
        element('table').tBodies[0].rows[0].click();
        document.body.dataset.detail = element('detail').textContent;
        const texts = [];
        for (const kind of element('coloring').options) {
            element('coloring').value = kind.value;
            element('coloring').dispatchEvent(new Event('change'));
            texts.push(element('legend').textContent);
        }
        document.body.dataset.legends = texts.join('|');)");
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const std::string& dom = result.output;
    EXPECT_NE(dom.find("data-rendered=\"yes\""), std::string::npos);
    EXPECT_EQ(dom.find("data-error"), std::string::npos);
    EXPECT_NE(dom.find("data-tip=\"table 2: "), std::string::npos)
        << "the biggest has a name first";
    EXPECT_NE(dom.find("data-rows=\"1\""), std::string::npos);
    EXPECT_NE(dom.find("data-detail=\"chair 1: seen 3 times, 200 voxels"), std::string::npos);
    const size_t legends = dom.find("data-legends=");
    ASSERT_NE(legends, std::string::npos);
    EXPECT_EQ(dom.substr(legends, 55), "data-legends=\"table 2chair 1no object|tablechairno obje");
}
