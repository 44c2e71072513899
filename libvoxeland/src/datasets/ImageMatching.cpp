// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/ImageMatching.h"

#include "ImageName.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace voxeland
{
namespace
{
using Images = std::vector<PredictedImage>;
using Frames = std::vector<DatasetFrame>;
using Number = std::optional<int64_t>;

const std::string REMEDY = ": rgbd2rawlog --predictions matches by the dataset's own file names";

/** Path of each file, the file's name first. */
using Paths = std::vector<std::vector<std::string>>;

/** Positions of the paths by their first parts; those of fewer parts are left out. */
std::map<std::string, std::vector<size_t>> byEnd(const Paths& paths, size_t parts)
{
    std::map<std::string, std::vector<size_t>> result;
    for (size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].size() < parts) continue;
        std::string end;
        for (size_t p = 0; p < parts; ++p) end += paths[i][p] + "/";
        result[end].push_back(i);
    }
    return result;
}

bool shareAName(const Paths& images, const Paths& frames)
{
    const auto names = byEnd(frames, 1);
    const auto isOfAFrame = [&](const auto& name) { return names.count(name.first) > 0; };
    const auto imageNames = byEnd(images, 1);
    return std::any_of(imageNames.begin(), imageNames.end(), isOfAFrame);
}

/** A name that several images or several frames have, and no folder tells apart; or none. */
std::string ambiguousName(const Images& images, const Paths& paths, const Paths& frames,
                          const ImageMatching& matching)
{
    std::set<size_t> matched;
    for (const auto& image : matching.imageOf)
        if (image) matched.insert(*image);
    const auto names = byEnd(frames, 1), imageNames = byEnd(paths, 1);
    for (const auto& [name, which] : imageNames) {
        const auto found = names.find(name);
        if (found == names.end() || matched.count(which.front()) > 0) continue;
        if (found->second.size() > 1 || which.size() > 1) return images[which.front()].name;
    }
    return "";
}

/** Where a path ends like one path only on the other side, and that one like no other, they match;
 *  the longest common ends first. */
std::optional<ImageMatching> matchedByName(const Images& images, const Frames& frames)
{
    Paths framePaths;
    for (const DatasetFrame& f : frames) framePaths.push_back(imagePath(f.image));
    Paths paths;
    for (const auto& original :
         {+[](const std::string& name) { return name; }, &beforeRoboflow, &beforeLabelStudio})
    {
        paths.clear();
        for (const PredictedImage& i : images) paths.push_back(imagePath(original(i.name)));
        if (shareAName(paths, framePaths)) break;
        paths.clear();
    }
    if (paths.empty()) return std::nullopt;

    ImageMatching matching{std::vector<std::optional<size_t>>(frames.size()), "by file name", ""};
    std::vector<bool> isMatched(images.size(), false);
    size_t deepest = 0;
    for (const auto& path : paths) deepest = std::max(deepest, path.size());
    for (size_t parts = deepest; parts > 0; --parts) {
        const auto imageEnds = byEnd(paths, parts), frameEnds = byEnd(framePaths, parts);
        for (const auto& [end, which] : imageEnds) {
            const auto found = frameEnds.find(end);
            if (found == frameEnds.end() || found->second.size() > 1 || which.size() > 1) continue;
            auto& image = matching.imageOf[found->second.front()];
            if (image || isMatched[which.front()]) continue;
            image = which.front();
            isMatched[which.front()] = true;
        }
    }
    if (const auto name = ambiguousName(images, paths, framePaths, matching); !name.empty())
        matching.doubt = "'" + name + "' may be several images: their folders would tell";
    return matching;
}

/** Whether one of the images has an earlier name than the one listed before it. */
bool areShuffled(const Images& images)
{
    const auto isEarlier = [](const PredictedImage& a, const PredictedImage& b) {
        return comesBefore(b.name, a.name);
    };
    return std::adjacent_find(images.begin(), images.end(), isEarlier) != images.end();
}

ImageMatching matchedInOrder(const Images& images, const Frames& frames)
{
    ImageMatching matching{std::vector<std::optional<size_t>>(frames.size()),
                           "in the order of the file's images", ""};
    for (size_t i = 0; i < std::min(frames.size(), images.size()); ++i) matching.imageOf[i] = i;
    const auto comesLater = [](const PredictedImage& a, const PredictedImage& b) {
        const Number before = numberIn(a.name), after = numberIn(b.name);
        return before && after && *before > *after && !comesBefore(a.name, b.name);
    };
    if (images.size() != frames.size())
        matching.doubt = "it lists " + counted(images.size(), "image") + " for " +
                         counted(frames.size(), "frame") + REMEDY;
    else if (std::adjacent_find(images.begin(), images.end(), comesLater) != images.end())
        matching.doubt = "the names of its images are in another order" + REMEDY;
    return matching;
}

/** A way to number frames. */
struct Numbering
{
    std::string how;
    std::function<Number(size_t position)> of;
};

/** By position among the frames. */
Numbering countedFrom(int64_t first)
{
    return {"by position, counted from " + std::to_string(first),
            [first](size_t i) { return Number(static_cast<int64_t>(i) + first); }};
}

std::vector<Numbering> numberings(const Frames& frames)
{
    return {{"by frame number", [&](size_t i) { return Number(frames[i].number); }},
            {"by the number that is the image's file name",
             [&](size_t i) { return numberThatIs(frames[i].image); }},
            countedFrom(1),
            countedFrom(0)};
}

/** Positions of the images by their numbers; of equal ones the first. */
std::map<int64_t, size_t> byNumber(const std::vector<Number>& numbers)
{
    std::map<int64_t, size_t> result;
    for (size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i]) result.emplace(*numbers[i], i);
    return result;
}

/** How many predictions have a frame. */
size_t predictionsIn(const ImageMatching& matching, const Images& images)
{
    size_t predictions = 0;
    for (const auto& image : matching.imageOf)
        if (image) predictions += images[*image].predictions;
    return predictions;
}

ImageMatching matchedBy(const Numbering& numbering, const std::map<int64_t, size_t>& imageOfNumber,
                        size_t frames)
{
    ImageMatching matching{{}, numbering.how, ""};
    std::set<size_t> matched;
    for (size_t f = 0; f < frames; ++f) {
        const Number number = numbering.of(f);
        const auto found = number ? imageOfNumber.find(*number) : imageOfNumber.end();
        auto& image = matching.imageOf.emplace_back();
        if (found != imageOfNumber.end() && matched.insert(found->second).second)
            image = found->second;
    }
    return matching;
}

/** The usual numbering, unless another one alone leaves no prediction without a frame. */
ImageMatching matchedByNumber(const Images& images, const std::vector<Number>& numbers,
                              const Frames& frames)
{
    const auto imageOfNumber = byNumber(numbers);
    size_t all = 0;
    for (const PredictedImage& i : images) all += i.predictions;
    const auto ways = numberings(frames);
    for (const Numbering& numbering : ways) {
        auto matching = matchedBy(numbering, imageOfNumber, frames.size());
        if (predictionsIn(matching, images) == all) return matching;
    }
    return matchedBy(ways.front(), imageOfNumber, frames.size());
}

/** Says so where images are named, but not as frames are, and where numbers may as well count the
 *  frames from 1: 0 is not among them though most frames' are, or 1 is the first. */
ImageMatching doubted(ImageMatching matching, const Images& images,
                      const std::vector<Number>& numbers, const Frames& frames)
{
    if (std::any_of(images.begin(), images.end(), [](const auto& i) { return !i.number; })) {
        matching.doubt = "none has the name of a frame's image" + REMEDY;
        return matching;
    }
    const auto imageOfNumber = byNumber(numbers);
    if (imageOfNumber.empty()) return matching;
    const int64_t first = imageOfNumber.begin()->first;
    if (first < 1 || (first > 1 && 2 * imageOfNumber.size() < frames.size())) return matching;
    const auto fromOne = matchedBy(countedFrom(1), imageOfNumber, frames.size());
    if (fromOne.imageOf != matching.imageOf &&
        predictionsIn(fromOne, images) >= predictionsIn(matching, images))
        matching.doubt =
            "they may as well be counted from 1, as 0 is not among them: give ids from 0, or a list"
            " 'images' with file names";
    return matching;
}

/** Whether numbers go 0, 1, 2, ... or 1, 2, 3, ... */
bool countThrough(const std::vector<Number>& numbers)
{
    for (size_t i = 0; i < numbers.size(); ++i)
        if (*numbers[i] != *numbers.front() + static_cast<int64_t>(i)) return false;
    return numbers.empty() || *numbers.front() == 0 || *numbers.front() == 1;
}

/** Numbers in the names of listed images, if they say more of which frames these are than the
 *  order: nothing otherwise. */
std::optional<std::vector<Number>> tellingNumbers(const Images& images, const Frames& frames)
{
    std::set<int64_t> ofFrames, seen;
    for (const DatasetFrame& f : frames) ofFrames.insert(f.number);
    std::vector<Number> numbers;
    for (const PredictedImage& i : images) {
        numbers.push_back(i.name.empty() ? i.number : numberIn(i.name));
        if (!numbers.back() || ofFrames.count(*numbers.back()) == 0 ||
            !seen.insert(*numbers.back()).second)
            return std::nullopt;
    }
    return countThrough(numbers) ? std::nullopt : std::optional(numbers);
}
}  // namespace

ImageMatching matchImages(const Images& images, bool listed, const Frames& frames)
{
    if (auto matching = matchedByName(images, frames)) return *matching;
    if (listed) {
        const auto telling = tellingNumbers(images, frames);
        const bool areAll = images.size() == frames.size(), shuffled = areShuffled(images);
        if (shuffled && !(areAll && telling))
            throw InputError("its " + counted(images.size(), "image") +
                             " are not listed in the order of their names, and none has the name"
                             " of a frame's image" +
                             REMEDY);
        return telling && (shuffled || !areAll) ? matchedByNumber(images, *telling, frames)
                                                : matchedInOrder(images, frames);
    }
    std::vector<Number> numbers;
    for (const PredictedImage& i : images)
        numbers.push_back(i.number ? i.number : numberIn(i.name));
    return doubted(matchedByNumber(images, numbers, frames), images, numbers, frames);
}
}  // namespace voxeland
