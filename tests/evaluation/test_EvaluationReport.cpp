// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuilder.h"
#include "evaluation/EvaluationReport.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include <cmath>

using namespace voxeland;
using voxeland::test::SceneBuilder;

namespace
{
/** Of the paper's classes: a bed found, one of two chairs found, a toilet nobody annotated. */
EvaluatedScene bedroom()
{
    EvaluatedScene s = SceneBuilder()
                           .object(0, 400)
                           .object(1, 200)
                           .object(1, 200)
                           .instance(0, 400, 0.9)
                           .instance(1, 200, 0.8)
                           .instance(7, 200, 0.7)
                           .overlap(0, 0, 400)
                           .overlap(1, 1, 200)
                           .overlap(2, 2, 200);
    s.name = "bedroom";
    return s;
}

/** A chair, missed. */
EvaluatedScene corridor()
{
    EvaluatedScene s = SceneBuilder().object(1, 200);
    s.name = "corridor";
    return s;
}

EvaluationReport reportOf(const std::vector<EvaluatedScene>& scenes)
{
    EvaluationReport report(LabelMap::paper9(), {});
    for (const EvaluatedScene& s : scenes)
        report.add({s.name + ".voxeland", s.name + "_gt", 0.05, "expected"}, s);
    return report;
}
}  // namespace

TEST(Metrics, meansAreOverClassesWithObjects)
{
    const Metrics m = evaluate({bedroom()}, LabelMap::paper9().classes(), {});
    ASSERT_EQ(m.classes.size(), 3U);
    EXPECT_EQ(m.classes[0].name, "bed");
    EXPECT_EQ(m.classes[0].precision.ap, 1);
    EXPECT_EQ(m.classes[1].precision.ap50, 0.5);
    EXPECT_EQ(m.classes[2].name, "toilet");
    EXPECT_TRUE(std::isnan(m.classes[2].precision.ap50));
    EXPECT_TRUE(std::isnan(m.classes[2].pq));
    EXPECT_EQ(m.mean.precision.ap50, 0.75);
    EXPECT_EQ(m.mean.objects, 3U);
    EXPECT_EQ(m.mean.instances, 3U);
    EXPECT_DOUBLE_EQ(m.mean.pq, (1 + 2.0 / 3) / 2);  // chairs: one found, one missed
    EXPECT_DOUBLE_EQ(m.agnostic.precision.ap50, 1) << "the toilet has the chair's shape";
    EXPECT_EQ(m.uncertainty.judged, 3U);
    EXPECT_EQ(m.uncertainty.wrong, 1U);
    EXPECT_EQ(m.uncertainty.auroc, 1) << "the toilet is the least certain";
}

TEST(EvaluationReport, poolsScenesAndAveragesThem)
{
    const EvaluationReport report = reportOf({bedroom(), corridor()});
    // pooled: bed 1, chair 1/3; by scene: 0.75 and 0
    EXPECT_NEAR(report.pooled().mean.precision.ap50, (1 + 1.0 / 3) / 2, 1e-12);
    const auto json = nlohmann::json::parse(report.json());
    EXPECT_NEAR(json["pooled"]["mean"]["ap50"].get<double>(), 2.0 / 3, 1e-12);
    EXPECT_EQ(json["mean_over_scenes"]["ap50"], 0.375);
    EXPECT_EQ(json["scenes"].size(), 2U);
    EXPECT_NE(report.text().find("pooled"), std::string::npos);
    EXPECT_NE(report.text().find("corridor"), std::string::npos);
}

TEST(EvaluationReport, saysTheProtocolAndEachCounterpart)
{
    const auto json = nlohmann::json::parse(reportOf({bedroom()}).json());
    EXPECT_EQ(json["protocol"]["labels"], "paper9");
    EXPECT_EQ(json["protocol"]["void"], "ignore");
    EXPECT_EQ(json["protocol"]["min_points"], 100);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["map"], "bedroom.voxeland");
    EXPECT_EQ(scene["instances"][2]["class"], "toilet");
    EXPECT_EQ(scene["instances"][2]["object"], 3);
    EXPECT_EQ(scene["objects"][2]["iou"], 1);
    EXPECT_TRUE(scene["classes"][2]["ap50"].is_null());
    const auto empty = nlohmann::json::parse(reportOf({corridor()}).json());
    EXPECT_TRUE(empty["scenes"][0]["objects"][0]["instance"].is_null());
    EXPECT_TRUE(empty["pooled"]["uncertainty"]["category_entropy_auroc"].is_null());
}

TEST(EvaluationReport, textHasTheTableInPercent)
{
    const std::string text = reportOf({bedroom()}).text();
    EXPECT_NE(text.find("9 of paper9: bed, chair, sofa"), std::string::npos) << text;
    EXPECT_NE(text.find("chair"), std::string::npos);
    EXPECT_NE(text.find("   50.0   50.0   50.0   50.0   66.7  100.0   66.7"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("pooled"), std::string::npos) << "there is but one scene";
}

TEST(PrecisionCurve, csvAndPicture)
{
    const std::vector<PrecisionAtThreshold> curve = {{0.5, 0, 0}, {1.0, 4, 3}};
    EXPECT_EQ(precisionCurveCsv(curve),
              "threshold_nat,precision,instances,correct\n0.5,,0,0\n1,0.75,4,3\n");
    for (const auto& c : {curve, std::vector<PrecisionAtThreshold>()}) {
        const std::string png = precisionCurvePng(c, UncertaintyThreshold{0.7, 0.5});
        const std::vector<unsigned char> bytes(png.begin(), png.end());
        const cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
        EXPECT_GE(picture.cols, 800);
        EXPECT_GE(picture.rows, 400);
    }
}

TEST(Reliability, csvAndPicture)
{
    UncertaintyMetrics uncertainty;
    uncertainty.confidence.diagram = {{4, 0.25, 0.5}, {4, 0.75, 1}};
    uncertainty.pointConfidence.diagram = {{100, 0.5, 0.5}};
    EXPECT_EQ(reliabilityCsv(uncertainty),
              "of,decisions,probability,correct\ninstances,4,0.25,0.5\ninstances,4,0.75,1\n"
              "points,100,0.5,0.5\n");
    for (const auto& u : {uncertainty, UncertaintyMetrics()}) {
        const std::string png = reliabilityPng(u);
        const std::vector<unsigned char> bytes(png.begin(), png.end());
        EXPECT_GE(cv::imdecode(bytes, cv::IMREAD_COLOR).cols, 800);
    }
}

TEST(EvaluationProtocol, namesGoBothWays)
{
    for (const char* name : {"ignore", "fp"}) EXPECT_EQ(toString(voidPolicyFromString(name)), name);
    for (const char* name : {"probability", "certainty", "observations"})
        EXPECT_EQ(toString(scoreKindFromString(name)), name);
    EXPECT_THROW(voidPolicyFromString("none"), ConfigurationError);
    EXPECT_THROW(scoreKindFromString("none"), ConfigurationError);
}
