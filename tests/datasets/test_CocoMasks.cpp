// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/CocoMasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace voxeland;

namespace
{
using Runs = std::vector<uint32_t>;
using Polygon = std::vector<double>;

/** COCO's encoding as its definition says: each run as it is (first three) or less the last but
 *  one; groups of five bits, lowest first, 32 marking that more follow, offset 48. */
std::string encode(const Runs& runs)
{
    std::string text;
    for (size_t i = 0; i < runs.size(); ++i) {
        long x = static_cast<long>(runs[i]);
        if (i > 2) x -= static_cast<long>(runs[i - 2]);
        bool more = true;
        while (more) {
            long group = x & 31;
            x >>= 5;
            more = (group & 16) != 0 ? x != -1 : x != 0;
            if (more) group |= 32;
            text += static_cast<char>(group + 48);
        }
    }
    return text;
}

/** Runs of a row-major bitmap down its columns. */
Runs columnRuns(const std::vector<uint8_t>& bitmap, int width, int height)
{
    Runs runs = {0};
    uint8_t value = 0;
    for (int c = 0; c < width; ++c)
        for (int r = 0; r < height; ++r) {
            const uint8_t pixel = bitmap[static_cast<size_t>(r * width + c)];
            if (pixel != value) {
                runs.push_back(0);
                value = pixel;
            }
            ++runs.back();
        }
    return runs;
}

/** Bitmap of random rectangles. */
std::vector<uint8_t> randomBitmap(int width, int height, std::mt19937& random)
{
    std::vector<uint8_t> bitmap(static_cast<size_t>(width * height), 0);
    for (int n = static_cast<int>(random() % 6); n > 0; --n) {
        const int left = static_cast<int>(random()) & 0xFF, top = static_cast<int>(random()) & 0xFF;
        const auto value = static_cast<uint8_t>(random() & 1U);
        for (int r = top % height; r < std::min(height, top % height + 1 + top); ++r)
            for (int c = left % width; c < std::min(width, left % width + 1 + left / 2); ++c)
                bitmap[static_cast<size_t>(r * width + c)] = value;
    }
    return bitmap;
}

double distanceToSegment(double x, double y, const double* a, const double* b)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double length2 = dx * dx + dy * dy;
    const double t =
        length2 > 0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(x - a[0] - t * dx, y - a[1] - t * dy);
}

/** Even-odd rule, and the distance to the nearest edge. */
std::pair<bool, double> inside(const Polygon& p, double x, double y)
{
    bool in = false;
    double distance = 1e9;
    const size_t n = p.size() / 2;
    for (size_t i = 0, j = n - 1; i < n; j = i++) {
        const double *a = &p[2 * i], *b = &p[2 * j];
        if ((a[1] > y) != (b[1] > y) && x < (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) + a[0])
            in = !in;
        distance = std::min(distance, distanceToSegment(x, y, a, b));
    }
    return {in, distance};
}

void expectFilled(const std::vector<Polygon>& polygons, int width, int height)
{
    const auto bitmap = maskFromPolygons(width, height, polygons).toBitmap();
    for (int r = 0; r < height; ++r)
        for (int c = 0; c < width; ++c) {
            bool in = false;
            double distance = 1e9;
            for (const auto& p : polygons) {
                const auto [i, d] = inside(p, c + 0.5, r + 0.5);
                in = in || i;
                distance = std::min(distance, d);
            }
            if (distance > 1e-9) {
                EXPECT_EQ(bitmap[static_cast<size_t>(r * width + c)] != 0, in)
                    << "column " << c << ", row " << r;
            }
        }
}
}  // namespace

TEST(CocoMasks, decodesKnownTexts)
{
    EXPECT_EQ(decodeCocoCounts("01"), (Runs{0, 1}));
    EXPECT_EQ(decodeCocoCounts("112"), (Runs{1, 1, 2}));
    EXPECT_EQ(decodeCocoCounts("53500"), (Runs{5, 3, 5, 3, 5}));
    EXPECT_EQ(decodeCocoCounts(":1:W1J"), (Runs{10, 1, 10, 40, 4}));
    EXPECT_EQ(decodeCocoCounts(""), Runs());
}

TEST(CocoMasks, runsGoDownTheColumns)
{
    // Two by two pixels; only row 1 of column 0 is set.
    const RunLengthMask mask = maskFromColumnRuns(2, 2, {1, 1, 2});
    EXPECT_EQ(mask.toBitmap(), (std::vector<uint8_t>{0, 0, 1, 0}));
    // Three wide, two high; column 1 is set.
    EXPECT_EQ(maskFromColumnRuns(3, 2, {2, 2, 2}).toBitmap(),
              (std::vector<uint8_t>{0, 1, 0, 0, 1, 0}));
}

TEST(CocoMasks, decodesWhatIsEncodedByTheDefinition)
{
    std::mt19937 random(7);
    for (int i = 0; i < 500; ++i) {
        const int width = 1 + static_cast<int>(random() % 90),
                  height = 1 + static_cast<int>(random() % 70);
        const auto bitmap = randomBitmap(width, height, random);
        const Runs runs = columnRuns(bitmap, width, height);
        const std::string text = encode(runs);
        ASSERT_EQ(decodeCocoCounts(text), runs) << text;
        ASSERT_EQ(maskFromColumnRuns(width, height, runs).toBitmap(), bitmap);
    }
}

TEST(CocoMasks, decodesLongRuns)
{
    const Runs runs = {0, 4000000000U, 1, 2, 3999999999U, 0};
    EXPECT_EQ(decodeCocoCounts(encode(runs)), runs);
}

TEST(CocoMasks, refusesTextsThatAreNoCounts)
{
    for (const char* text : {"W", "1 1", "11p", "111@", "PPPPPPPPPPPPPPPPPPPPPP0", "\xE9"})
        EXPECT_THROW(decodeCocoCounts(text), std::invalid_argument) << text;
    EXPECT_THROW(maskFromColumnRuns(2, 2, {1, 1}), std::invalid_argument);
}

TEST(CocoMasks, fillsThePixelsWhoseCentreIsInside)
{
    expectFilled({{10, 5, 50, 8, 40, 38, 5, 30}}, 64, 48);
    expectFilled({{10.3, 5.7, 30.2, 20.1, 50.9, 6.6, 48.4, 40.5, 12.5, 35.25}}, 64, 48);
    expectFilled({{5, 5, 20, 5, 20, 20, 5, 20}, {30, 10, 60, 10, 45, 44}}, 64, 48);
    expectFilled({{5, 5, 30, 5, 30, 30, 5, 30}, {15, 15, 45, 15, 45, 45, 15, 45}}, 64, 48);
    expectFilled({{-20, -10, 90, -10, 30, 70}}, 64, 48);
    expectFilled({{5.2, 5.1, 60.3, 40.2, 60.1, 5.4, 5.6, 40.8}}, 64, 48);
    expectFilled({{-1e6, -1e6, 1e6, -1e6, 1e6, 1e6, -1e6, 1e6}}, 64, 48);
}

TEST(CocoMasks, fillsTheWholePixelsOfARectangle)
{
    // Columns 10 to 19 and rows 20 to 24, as COCO's pixel edges say.
    const RunLengthMask mask = maskFromPolygons(64, 48, {{10, 20, 20, 20, 20, 25, 10, 25}});
    EXPECT_EQ(mask.area(), 50U);
    const PixelBox box = mask.boundingBox();
    EXPECT_EQ(box.x, 10);
    EXPECT_EQ(box.y, 20);
    EXPECT_EQ(box.width, 10);
    EXPECT_EQ(box.height, 5);
}

TEST(CocoMasks, refusesPolygonsThatAreNone)
{
    EXPECT_THROW(maskFromPolygons(9, 9, {{1, 1, 2, 2}}), std::invalid_argument);
    EXPECT_THROW(maskFromPolygons(9, 9, {{1, 1, 2, 2, 3, 3, 4}}), std::invalid_argument);
    EXPECT_THROW(maskFromPolygons(9, 9, {{1, 1, 2, 2, 3, NAN}}), std::invalid_argument);
    EXPECT_THROW(maskFromPolygons(9, 9, {{1, 1, 2, 2, 3, 2e6}}), std::invalid_argument);
}
