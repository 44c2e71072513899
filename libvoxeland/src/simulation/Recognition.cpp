// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Recognition.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voxeland::simulation
{
namespace
{
constexpr float PI = 3.14159265F;

/** For each category of the vocabulary, those it is mistaken for, the likeliest first. */
const std::map<std::string, std::vector<std::string>>& confusions()
{
    static const std::map<std::string, std::vector<std::string>> table{
        {"backpack", {"handbag", "suitcase", "chair"}},
        {"bed", {"couch", "dining table"}},
        {"bench", {"chair", "couch"}},
        {"book", {"laptop", "cell phone", "remote"}},
        {"bottle", {"vase", "cup"}},
        {"bowl", {"cup", "sink"}},
        {"cell phone", {"remote", "book"}},
        {"chair", {"couch", "bench", "dining table"}},
        {"couch", {"bed", "chair", "bench"}},
        {"cup", {"bowl", "bottle", "vase"}},
        {"dining table", {"bench", "bed", "chair"}},
        {"handbag", {"backpack", "suitcase"}},
        {"laptop", {"tv", "book", "keyboard"}},
        {"keyboard", {"laptop", "remote"}},
        {"microwave", {"oven", "tv"}},
        {"oven", {"microwave", "refrigerator"}},
        {"potted plant", {"vase", "bowl"}},
        {"refrigerator", {"oven", "microwave"}},
        {"remote", {"cell phone", "book"}},
        {"sink", {"bowl", "toilet"}},
        {"suitcase", {"backpack", "handbag"}},
        {"toilet", {"chair", "sink"}},
        {"tv", {"laptop", "microwave"}},
        {"umbrella", {"vase", "potted plant"}},
        {"vase", {"bottle", "cup", "potted plant"}},
    };
    return table;
}

/** For each category the detector has no word for, the words it uses instead. */
const std::vector<std::string>& unknownAs(const std::string& category)
{
    static const std::map<std::string, std::vector<std::string>> table{
        {"bookshelf", {"refrigerator", "book"}},
        {"box", {"suitcase", "backpack", "microwave"}},
        {"cabinet", {"oven", "dining table", "bench"}},
        {"floor lamp", {"umbrella", "vase"}},
        {"kitchen cabinet", {"oven", "dining table", "sink"}},
        {"nightstand", {"suitcase", "oven", "chair"}},
        {"picture", {"tv", "laptop"}},
        {"plant stand", {"chair", "dining table", "bench"}},
        {"wardrobe", {"refrigerator", "oven"}},
    };
    return table.at(category);
}

const std::string& oneOf(const std::vector<std::string>& names, Random& random)
{
    return names[static_cast<size_t>(random.below(static_cast<int>(names.size())))];
}

std::vector<std::string> shuffled(std::vector<std::string> names, Random& random)
{
    for (size_t i = names.size(); i > 1; --i)
        std::swap(names[i - 1], names[static_cast<size_t>(random.below(static_cast<int>(i)))]);
    return names;
}

/** Azimuth from an object towards the middle of its room: it is seen from around there. */
float openDirection(const SceneObject& object, const Scene& scene)
{
    const Vector3 c = object.bounds.center();
    for (const auto& r : scene.rooms())
        if (c.x >= r.minX && c.x <= r.maxX && c.y >= r.minY && c.y <= r.maxY)
            return std::atan2((r.minY + r.maxY) / 2 - c.y, (r.minX + r.maxX) / 2 - c.x);
    return 0;
}
}  // namespace

const std::vector<std::string>& Recognition::vocabulary()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& entry : confusions()) all.push_back(entry.first);
        return all;
    }();
    return names;
}

Recognition::Recognition(const Scene& scene, const DetectorOptions& options, Random random)
    : m_options(options)
{
    for (const auto& object : scene.objects()) {
        Look look;
        const bool known = confusions().count(object.category) > 0;
        look.names = known ? std::vector<std::string>{object.category}
                           : shuffled(unknownAs(object.category), random);
        look.alternative = oneOf(confusions().at(look.names.front()), random);
        look.advantage = known ? options.confidence : options.unknownConfidence;
        look.confused = random.chance(options.confusedObjects);
        look.front = openDirection(object, scene);
        look.sectorMiddle = look.front + random.uniform(-0.55F, 0.55F) * PI;
        m_looks.push_back(look);
        m_centers.push_back(object.bounds.center());
    }
}

const std::string& Recognition::nameFrom(const Look& look, float azimuth)
{
    constexpr float SEEN_FROM = 120 * PI / 180;  // the names share these directions
    const float off = std::remainder(azimuth - look.front, 2 * PI);
    const float place = std::clamp(off / SEEN_FROM + 0.5F, 0.0F, 0.999F);
    return look.names[static_cast<size_t>(place * static_cast<float>(look.names.size()))];
}

CategoryDistribution Recognition::recognize(ObjectId object, const Vector3& from,
                                            Random& random) const
{
    constexpr float FADE = 25 * PI / 180;  // the confusion fades out over this angle
    const Look& look = m_looks.at(object - 1U);
    const Vector3 to = from - m_centers[object - 1U];
    const float azimuth = std::atan2(to.y, to.x);
    float share = 0;
    if (look.confused) {
        const float half = m_options.confusedSector / 2 * PI / 180;
        const float angle = std::abs(std::remainder(azimuth - look.sectorMiddle, 2 * PI));
        share = std::clamp((half + FADE / 2 - angle) / FADE, 0.0F, 1.0F);
    }
    return softmax({{nameFrom(look, azimuth), look.advantage},
                    {look.alternative, share * m_options.confusion}},
                   random);
}

CategoryDistribution Recognition::mistake(ObjectId object, Random& random) const
{
    const Look& look = m_looks.at(object - 1U);
    return softmax(
        {{look.names.front(), 0.5F * look.advantage}, {look.alternative, look.advantage}}, random);
}

CategoryDistribution Recognition::imagine(Random& random) const
{
    return softmax({{oneOf(vocabulary(), random), m_options.confidence * 0.7F}}, random);
}

CategoryDistribution Recognition::softmax(const std::vector<std::pair<std::string, float>>& raised,
                                          Random& random) const
{
    constexpr size_t LONGEST = 8;        // less likely names are left out
    constexpr float BACKGROUND = -1.0F;  // logit of unlikely categories
    CategoryDistribution result;
    for (const auto& name : vocabulary()) {
        float logit = BACKGROUND;
        for (const auto& [raisedName, raisedLogit] : raised)
            if (raisedName == name) logit = std::max(logit, raisedLogit);
        result.push_back({name, std::exp(logit + random.normal(m_options.logitNoise))});
    }
    result = normalized(result);
    const float best = result.front().probability;
    const auto minor = std::find_if(result.begin(), result.end(),
                                    [&](const auto& c) { return c.probability < 1e-4F * best; });
    result.erase(minor, result.end());
    if (result.size() > LONGEST) result.resize(LONGEST);
    return normalized(result);
}
}  // namespace voxeland::simulation
