// SPDX-License-Identifier: BSD-3-Clause
#include "ViewPictures.h"

#include "rawlogs/FrameFinder.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/ColourImage.h"
#include "voxeland/observations/UnusableFrame.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace voxeland
{
namespace
{
using Contours = std::vector<std::vector<cv::Point>>;

cv::Rect toCv(const PixelBox& b)
{
    return {b.x, b.y, b.width, b.height};
}

std::string asJpeg(const cv::Mat& image)
{
    std::vector<uchar> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 90});
    return {bytes.begin(), bytes.end()};
}

/** The prediction a view was made from, null if it is not among these. */
const InstancePrediction* predictionOf(const InstanceView& view,
                                       const CObservationInstances* predictions)
{
    if (predictions == nullptr) return nullptr;
    for (const InstancePrediction& p : predictions->instances) {
        const ImageRegion region = regionOf(p.mask);
        if (region.box == view.box && region.area == view.area) return &p;
    }
    return nullptr;
}

/** Outlines of an object in its image. */
Contours outlineOf(const InstanceView& view, const InstancePrediction* prediction)
{
    const cv::Rect box = toCv(view.box);
    if (prediction == nullptr)
        return {{box.tl(),
                 {box.x, box.br().y - 1},
                 box.br() - cv::Point(1, 1),
                 {box.br().x - 1, box.y}}};
    std::vector<uint8_t> bitmap = prediction->mask.toBitmap();
    const cv::Mat mask(prediction->mask.height(), prediction->mask.width(), CV_8U, bitmap.data());
    Contours contours;
    cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    return contours;
}

/** Part of an image, scaled, with outlines: white within black, to be seen on any ground and to
 * hide no colour. */
cv::Mat pictured(const cv::Mat& image, const cv::Rect& part, double scale, Contours outlines)
{
    cv::Mat picture;
    cv::resize(image(part), picture, {}, scale, scale,
               scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    for (auto& outline : outlines)
        for (cv::Point& p : outline)
            p = {static_cast<int>((p.x - part.x + 0.5) * scale),
                 static_cast<int>((p.y - part.y + 0.5) * scale)};
    cv::polylines(picture, outlines, true, cv::Scalar::all(0), 3, cv::LINE_AA);
    cv::polylines(picture, outlines, true, cv::Scalar::all(255), 1, cv::LINE_AA);
    return picture;
}

double scaleFor(const cv::Rect& part, uint32_t size)
{
    constexpr double MOST = 4;  // what is enlarged more shows nothing more
    return std::min(MOST, static_cast<double>(size) / std::max(part.width, part.height));
}

/** \throws InputError, naming the rawlog */
cv::Mat colourImage(const RgbdFrame& frame, const std::string& rawlog)
{
    if (!frame.scan->hasIntensityImage)
        throw InputError("'" + rawlog + "' has no colour images: there is nothing to show");
    try {
        return voxeland::colourImage(*frame.scan);
    } catch (const UnusableFrame& e) {
        throw InputError("'" + rawlog + "': " + e.what());
    }
}

[[noreturn]] void sayOther(const std::string& rawlog, const std::string& why)
{
    throw InputError("'" + rawlog + "' is not the rawlog the map was made from: " + why);
}

/** Makes the pictures of one view. */
void picture(CandidateView& chosen, const cv::Mat& image, const InstancePrediction* prediction,
             const DisambiguationOptions& options)
{
    const cv::Rect box = toCv(chosen.view.box), whole(0, 0, image.cols, image.rows);
    const Contours outline = outlineOf(chosen.view, prediction);
    const auto margin =
        static_cast<int>(std::max(4.0, options.crop_margin * std::max(box.width, box.height)));
    const cv::Rect part =
        cv::Rect(box.tl() - cv::Point(margin, margin), box.br() + cv::Point(margin, margin)) &
        whole;
    chosen.picture = asJpeg(pictured(image, part, scaleFor(part, options.picture_size), outline));
    chosen.sharpness = sharpnessOf(image(box));
    if (options.whole_frame)
        chosen.wholeFrame = asJpeg(
            pictured(image, whole, std::min(1.0, scaleFor(whole, options.picture_size)), outline));
}
}  // namespace

float sharpnessOf(const cv::Mat& image)
{
    constexpr double SIDE = 128;  // sharpness is compared at one size, whatever the distance was
    const double scale = SIDE / std::max(image.cols, image.rows);
    cv::Mat grey, laplacian;
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    cv::resize(grey, grey, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    cv::Laplacian(grey, laplacian, CV_64F);
    cv::Scalar mean, ofGrey, ofLaplacian;
    cv::meanStdDev(grey, mean, ofGrey);
    cv::meanStdDev(laplacian, mean, ofLaplacian);
    return ofGrey[0] > 0 ? static_cast<float>(std::pow(ofLaplacian[0] / ofGrey[0], 2)) : 0;
}

size_t fetchPictures(std::vector<UncertainInstance>& instances, const std::string& rawlog,
                     const MapperConfig& config, const std::function<void(double)>& progress)
{
    std::multimap<mrpt::Clock::time_point, CandidateView*> wishes;
    FrameFinder::Times times;
    for (UncertainInstance& u : instances)
        for (CandidateView& v : u.views) {
            wishes.emplace(v.view.time, &v);
            times.insert(v.view.time);
        }
    if (wishes.empty()) return 0;

    // Only what is recorded with the rawlog can be compared with what the map remembers.
    const bool comparable =
        config.converter && std::string(config.converter->GetRuntimeClass()->className) ==
                                "voxeland::CRecordedInstancesConverter";
    FrameFinder finder(rawlog, config.input, times);
    size_t found = 0, different = 0;
    while (const auto frame = finder.next()) {
        progress(finder.progress());
        const cv::Mat image = colourImage(*frame, rawlog);
        const auto [first, last] = wishes.equal_range(frame->scan->timestamp);
        for (auto wish = first; wish != last; ++wish) {
            const cv::Rect box = toCv(wish->second->view.box);
            if (box.empty() || (box & cv::Rect(0, 0, image.cols, image.rows)) != box)
                sayOther(rawlog, "its images have another size");
            const auto* prediction = predictionOf(wish->second->view, frame->instances.get());
            picture(*wish->second, image, prediction, config.disambiguation);
            different += prediction == nullptr ? 1 : 0;
            ++found;
        }
    }
    if (found == 0) sayOther(rawlog, "it holds none of the frames that show uncertain objects");
    if (comparable && 2 * different > found)
        sayOther(rawlog, "its predictions are not those that the map remembers");
    return wishes.size() - std::min(found, wishes.size());
}
}  // namespace voxeland
