// SPDX-License-Identifier: BSD-3-Clause
#include "disambiguation/ViewChoice.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace voxeland;

namespace
{
/** From an azimuth [degrees], with a quality. */
CandidateView view(uint32_t frame, double azimuth, uint32_t quality, float sharpness = 1)
{
    CandidateView c;
    c.sharpness = sharpness;
    c.picture = "fetched";
    InstanceView& v = c.view;
    v.frame = frame;
    v.area = quality * quality;
    v.score = v.probability = 1;
    const double a = azimuth * M_PI / 180;
    v.camera = {static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a)), 0};
    return c;
}

/** Good ones at the front, a fair one at the side, a poor one behind. */
const std::vector<CandidateView> VIEWS = {view(1, 0, 100), view(2, 10, 95), view(3, 90, 60),
                                          view(4, 180, 10)};

std::vector<uint32_t> chosen(size_t most)
{
    std::vector<uint32_t> frames;
    for (const auto& v : chooseViews(VIEWS, most)) frames.push_back(v.view.frame);
    return frames;
}
using Frames = std::vector<uint32_t>;
}  // namespace

TEST(ViewChoice, GoodViewsFromAnotherSide)
{
    // After 1: 2 is worth 95*10, 3 60*90, 4 10*90. Then 2 950, 4 900.
    EXPECT_EQ(chosen(2), (Frames{1, 3}));
    EXPECT_EQ(chosen(3), (Frames{1, 3, 2}));
}

TEST(ViewChoice, FewerIfThereAreNotAsMany)
{
    EXPECT_EQ(chosen(9).size(), 4U);
    EXPECT_TRUE(chooseViews({}, 3).empty());
}

TEST(ViewChoice, ABlurredViewIsWorthLess)
{
    // 1 is worth 100 * 0.4, 2 90 * 1.
    const std::vector<CandidateView> views = {view(1, 0, 100, 0.2F), view(2, 5, 90, 0.5F)};
    EXPECT_EQ(chooseViews(views, 1)[0].view.frame, 2U);
}

TEST(ViewChoice, EachCandidateKeepsItsViewsAndTheFirstItsFrame)
{
    UncertainInstance u;
    u.candidates = {{7, "couch", 0.6}, {3, "bed", 0.4}};
    for (const category_id_t category : {3U, 7U, 3U, 7U}) {
        u.views.push_back(view(static_cast<uint32_t>(u.views.size()), 0, 100));
        u.views.back().category = category;
        u.views.back().wholeFrame = "frame";
    }
    u.views[1].picture.clear();  // the rawlog lacks it
    DisambiguationOptions options;
    options.views_per_category = 1;
    keepChosenViews(u, options);
    ASSERT_EQ(u.views.size(), 2U);
    EXPECT_EQ(u.views[0].view.frame, 3U);
    EXPECT_EQ(u.views[1].view.frame, 0U);
    EXPECT_EQ(u.views[0].wholeFrame, "frame");
    EXPECT_EQ(u.views[1].wholeFrame, "");
}
