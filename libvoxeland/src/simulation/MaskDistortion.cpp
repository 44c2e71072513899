// SPDX-License-Identifier: BSD-3-Clause
#include "MaskDistortion.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
namespace
{
/** Smooth random field of the given size: independent values on a coarse grid, interpolated. */
cv::Mat1f smoothNoise(const cv::Size& size, float cell, float sigma, Random& random)
{
    const auto cells = [&](int length) {
        return 2 + static_cast<int>(static_cast<float>(length) / cell);
    };
    cv::Mat1f coarse(cells(size.height), cells(size.width)), fine;
    for (float& value : coarse) value = random.normal(sigma);
    cv::resize(coarse, fine, size, 0, 0, cv::INTER_LINEAR);
    return fine;
}

cv::Rect boundingRectangle(const Bitmap& mask)
{
    const cv::Mat1b image(mask.height, mask.width, const_cast<uint8_t*>(mask.pixels.data()));
    return cv::boundingRect(image);
}
}  // namespace

int Bitmap::area() const
{
    return static_cast<int>(
        std::count_if(pixels.begin(), pixels.end(), [](uint8_t p) { return p != 0; }));
}

Bitmap distorted(const Bitmap& mask, const DetectorOptions& o, float scale, Random& random)
{
    if (o.boundaryBias == 0 && o.boundaryNoise == 0 && o.maskShift == 0) return mask;
    const cv::Rect all(0, 0, mask.width, mask.height), tight = boundingRectangle(mask);
    if (tight.empty()) return mask;

    // Networks predict masks on a coarse grid in the object's box: large objects have larger
    // errors.
    const float size = std::sqrt(static_cast<float>(mask.area())) / scale;
    const float sigma = o.boundaryNoise * scale * std::clamp(size / 100, 0.5F, 2.0F);
    const float cell = std::max(6.0F, 0.12F * size) * scale;
    const int dx = static_cast<int>(std::lround(random.normal(o.maskShift * scale))),
              dy = static_cast<int>(std::lround(random.normal(o.maskShift * scale)));
    const int margin = 2 +
                       static_cast<int>(std::ceil(std::abs(o.boundaryBias) * scale + 3 * sigma)) +
                       std::max(std::abs(dx), std::abs(dy));
    const cv::Rect region = cv::Rect(tight.x - margin, tight.y - margin, tight.width + 2 * margin,
                                     tight.height + 2 * margin) &
                            all;

    const cv::Mat1b whole(mask.height, mask.width, const_cast<uint8_t*>(mask.pixels.data()));
    cv::Mat outside;
    cv::compare(whole(region), 0, outside, cv::CMP_EQ);
    cv::Mat1f toOutside, toInside;
    cv::distanceTransform(whole(region), toOutside, cv::DIST_L2, 3);
    cv::distanceTransform(outside, toInside, cv::DIST_L2, 3);
    const cv::Mat1f noise = smoothNoise(region.size(), cell, sigma, random);

    Bitmap result{mask.width, mask.height, std::vector<uint8_t>(mask.pixels.size(), 0)};
    for (int y = 0; y < region.height; ++y)
        for (int x = 0; x < region.width; ++x) {
            const cv::Point p(region.x + x + dx, region.y + y + dy);
            const float level =
                toOutside(y, x) - toInside(y, x) + noise(y, x) + o.boundaryBias * scale;
            if (level > 0 && all.contains(p))
                result.pixels[static_cast<size_t>(p.y) * static_cast<size_t>(mask.width) +
                              static_cast<size_t>(p.x)] = 1;
        }
    return result;
}

std::vector<Bitmap> cutInTwo(const Bitmap& mask, Random& random)
{
    const cv::Rect box = boundingRectangle(mask);
    const float angle = random.uniform(0.0F, 6.2831853F);
    const float nx = std::cos(angle), ny = std::sin(angle);
    const float shareX = random.uniform(0.35F, 0.65F), shareY = random.uniform(0.35F, 0.65F);
    const float px = static_cast<float>(box.x) + shareX * static_cast<float>(box.width),
                py = static_cast<float>(box.y) + shareY * static_cast<float>(box.height);
    Bitmap one{mask.width, mask.height, std::vector<uint8_t>(mask.pixels.size(), 0)}, other = one;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const auto i =
                static_cast<size_t>(y) * static_cast<size_t>(mask.width) + static_cast<size_t>(x);
            if (mask.pixels[i] == 0) continue;
            const float side =
                nx * (static_cast<float>(x) - px) + ny * (static_cast<float>(y) - py);
            (side > 0 ? one : other).pixels[i] = 1;
        }
    if (one.area() < other.area()) std::swap(one, other);
    return {one, other};
}
}  // namespace voxeland::simulation
