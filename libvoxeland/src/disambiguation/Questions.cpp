// SPDX-License-Identifier: BSD-3-Clause
#include "Questions.h"

#include "base/ClassicNumbers.h"
#include "pictures/InstancePicture.h"
#include "voxeland/base/printable.h"

#include <mrpt/core/format.h>
#include <opencv2/imgcodecs.hpp>

namespace voxeland
{
namespace
{
constexpr auto JPEG = "image/jpeg", PNG = "image/png";

std::string caption(const CandidateView& v, const SemanticVoxelMap& map)
{
    const auto ray = v.view.target - v.view.camera;
    return format(
        "Photograph in which a detector took the object for: %s (%.0f %%), from "
        "%.1f m%s",
        printable(map.categories().name(v.category)).c_str(),
        100 * static_cast<double>(v.view.probability), static_cast<double>(ray.norm()),
        v.view.truncated ? "; cut off" : "");
}
}  // namespace

DisambiguationQuestion questionAbout(const UncertainInstance& instance, const SemanticVoxelMap& map,
                                     const mrpt::math::TVector3D& up, const Prompt& prompt,
                                     const DisambiguationOptions& options)
{
    DisambiguationQuestion question;
    question.instance = instance.id;
    question.candidates = instance.candidates;
    for (const CandidateView& v : instance.views)
        if (!v.picture.empty()) question.pictures.push_back({caption(v, map), JPEG, v.picture});
    for (const CandidateView& v : instance.views)
        if (!v.wholeFrame.empty())
            question.pictures.push_back(
                {"Photograph of what surrounds the object", JPEG, v.wholeFrame});
    if (options.voxel_picture) {
        std::string voxels = instancePicture(map, GravityAlignedFrame(up), instance.id,
                                             static_cast<int>(options.picture_size * 3 / 4));
        if (!voxels.empty())
            question.pictures.push_back(
                {format("Reconstruction of the object's shape in voxels of %.0f cm: the "
                        "object is orange, other objects bluish, the rest grey",
                        100 * map.resolution()),
                 PNG, std::move(voxels)});
    }
    question.prompt = prompt.words(question);
    return question;
}

uint64_t estimatedTokens(const DisambiguationQuestion& question)
{
    constexpr uint64_t CHARACTERS_A_TOKEN = 4, TOKENS_A_PICTURE = 85, TOKENS_A_TILE = 170;
    constexpr int TILE = 512;
    uint64_t tokens = question.prompt.size() / CHARACTERS_A_TOKEN;
    for (const auto& p : question.pictures) {
        const cv::Mat image =
            cv::imdecode(std::vector<uchar>(p.bytes.begin(), p.bytes.end()), cv::IMREAD_GRAYSCALE);
        const int tiles = ((image.cols + TILE - 1) / TILE) * ((image.rows + TILE - 1) / TILE);
        tokens += TOKENS_A_PICTURE + TOKENS_A_TILE * static_cast<uint64_t>(tiles);
    }
    return tokens;
}

double costOf(uint64_t promptTokens, uint64_t answerTokens, const DisambiguationOptions& options)
{
    constexpr double MILLION = 1e6;
    return (static_cast<double>(promptTokens) * options.prompt_price +
            static_cast<double>(answerTokens) * options.answer_price) /
           MILLION;
}
}  // namespace voxeland
