// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/CameraPath.h"

#include "WalkableFloor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voxeland::simulation
{
namespace
{
constexpr float PI = 3.14159265F, DEG = PI / 180;
constexpr float TICK = 0.05F;  //!< time between the steps a tour is made of [s]

/** Where the camera is and looks at one tick; angles are not wrapped. */
struct Step
{
    float x, y, yaw, pitch;
};

/** A tour under construction: walking and turning at constant speeds. */
class Tour
{
 public:
    Tour(const FloorPoint& start, float height) : m_height(height)
    {
        m_steps.push_back({start.x, start.y, 0, -0.3F});
    }

    [[nodiscard]] FloorPoint position() const { return {m_steps.back().x, m_steps.back().y}; }

    /** Angle the camera would have to turn by to look at a point. */
    [[nodiscard]] float angleTo(const Vector3& target) const
    {
        const Step& s = m_steps.back();
        const float yaw = std::atan2(target.y - s.y, target.x - s.x);
        return std::remainder(yaw - s.yaw, 2 * PI);
    }

    /** Turns to a point and looks at it for a moment. */
    void lookAt(const Vector3& target)
    {
        constexpr float SPEED = 60 * DEG, STAY = 0.5F;
        const Step from = m_steps.back();
        const float turn = angleTo(target);
        const float distance = std::hypot(target.x - from.x, target.y - from.y);
        const float pitch = std::clamp(std::atan2(target.z - m_height, distance), -0.85F, 0.2F);
        const int n = 1 + static_cast<int>(std::abs(turn) / SPEED / TICK);
        for (int i = 1; i <= n; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(n);
            m_steps.push_back({from.x, from.y, from.yaw + share * turn,
                               from.pitch + share * (pitch - from.pitch)});
        }
        const Step last = m_steps.back();
        m_steps.insert(m_steps.end(), static_cast<size_t>(STAY / TICK), last);
    }

    /** Walks along a way, turning meanwhile so as to look at a point at the end. */
    void walk(const std::vector<FloorPoint>& way, const Vector3& target)
    {
        constexpr float SPEED = 0.6F;
        float length = 0;
        for (size_t i = 1; i < way.size(); ++i)
            length += std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
        const float yaw = std::atan2(target.y - way.back().y, target.x - way.back().x);
        const float turn = std::remainder(yaw - m_steps.back().yaw, 2 * PI);
        const Step from = m_steps.back();
        const int n = 1 + static_cast<int>(length / SPEED / TICK);
        for (int i = 1; i <= n; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(n);
            const float at = share * static_cast<float>(way.size() - 1);
            const auto k = std::min(static_cast<size_t>(at), way.size() - 1);
            const FloorPoint a = way[k], b = way[std::min(k + 1, way.size() - 1)];
            const float part = at - static_cast<float>(k);
            m_steps.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
                               from.yaw + share * turn, from.pitch});
        }
    }

    /** Nobody walks and turns with jerks: averages over about a second, three times. */
    [[nodiscard]] std::vector<Step> smoothed() const
    {
        constexpr int HALF = 6;
        auto steps = m_steps;
        for (int pass = 0; pass < 3; ++pass) {
            const auto before = steps;
            for (size_t i = 0; i < steps.size(); ++i) {
                Step sum{0, 0, 0, 0};
                for (int k = -HALF; k <= HALF; ++k) {
                    const auto j = std::clamp<ptrdiff_t>(static_cast<ptrdiff_t>(i) + k, 0,
                                                         static_cast<ptrdiff_t>(steps.size()) - 1);
                    const Step& s = before[static_cast<size_t>(j)];
                    sum = {sum.x + s.x, sum.y + s.y, sum.yaw + s.yaw, sum.pitch + s.pitch};
                }
                constexpr float N = 2 * HALF + 1;
                steps[i] = {sum.x / N, sum.y / N, sum.yaw / N, sum.pitch / N};
            }
        }
        return steps;
    }

 private:
    float m_height;
    std::vector<Step> m_steps;
};

/** A place to stop at, and what to look at from there. */
struct Viewpoint
{
    FloorPoint place;
    std::vector<Vector3> targets;
};

/** Four viewpoints in the quarters of a room, in turn; each object of the room becomes a target
 *  of that from which it is seen at the best distance. */
std::vector<Viewpoint> viewpointsOf(const Room& room, const Scene& scene,
                                    const WalkableFloor& floor, const FloorPoint& entry)
{
    constexpr float BEST_DISTANCE = 2.3F;
    constexpr std::array<std::array<float, 2>, 4> QUARTERS{
        {{0.25F, 0.25F}, {0.25F, 0.75F}, {0.75F, 0.75F}, {0.75F, 0.25F}}};
    const float dx = room.maxX - room.minX, dy = room.maxY - room.minY;
    std::vector<Viewpoint> result;
    for (const auto& q : QUARTERS) {
        const FloorPoint wish{room.minX + q[0] * dx, room.minY + q[1] * dy};
        const Vector3 middle{room.minX + dx / 2, room.minY + dy / 2, 0.7F};
        result.push_back({floor.nearestFree(wish, entry), {middle}});
    }
    if (entry.y > room.minY + dy / 2) {  // begin at the near side
        std::swap(result[0], result[1]);
        std::swap(result[2], result[3]);
    }

    for (const auto& object : scene.objects()) {
        const Vector3 c = object.bounds.center();
        const bool inside =
            c.x > room.minX && c.x < room.maxX && c.y > room.minY && c.y < room.maxY;
        if (!inside || object.standsOn != STRUCTURE) continue;
        const auto error = [&](const Viewpoint& v) {
            return std::abs(std::hypot(c.x - v.place.x, c.y - v.place.y) - BEST_DISTANCE);
        };
        std::min_element(result.begin(), result.end(), [&](const auto& a, const auto& b) {
            return error(a) < error(b);
        })->targets.push_back(c);
    }
    return result;
}

/** Looks at all targets, always at the next to the left or right, leaving out those that are in
 *  view anyway. */
void lookAround(Tour& tour, std::vector<Vector3> targets)
{
    constexpr float SAME_VIEW = 12 * DEG;
    while (!targets.empty()) {
        const auto next = std::min_element(
            targets.begin(), targets.end(), [&](const Vector3& a, const Vector3& b) {
                return std::abs(tour.angleTo(a)) < std::abs(tour.angleTo(b));
            });
        if (std::abs(tour.angleTo(*next)) > SAME_VIEW) tour.lookAt(*next);
        targets.erase(next);
    }
}

/** The slow swinging of a hand: a few sine waves of random phase; between -1 and 1. */
class Shake
{
 public:
    explicit Shake(Random& random)
    {
        for (auto& p : m_phases) p = random.uniform(0, 2 * PI);
    }
    [[nodiscard]] float at(float time) const
    {
        return (std::sin(2.1F * time + m_phases[0]) + std::sin(5.3F * time + m_phases[1]) +
                std::sin(11.9F * time + m_phases[2])) /
               3;
    }

 private:
    std::array<float, 3> m_phases{};
};
}  // namespace

CameraPath::CameraPath(const Scene& scene, const CameraOptions& o, Random random)
{
    const WalkableFloor floor(scene);
    const Room& first = scene.rooms().front();
    const FloorPoint middle{(first.minX + first.maxX) / 2, (first.minY + first.maxY) / 2};
    Tour tour(floor.nearestFree({first.minX + 0.8F, first.minY + 0.8F}, middle), o.carryHeight);
    for (const auto& room : scene.rooms())
        for (const auto& viewpoint : viewpointsOf(room, scene, floor, tour.position())) {
            tour.walk(floor.way(tour.position(), viewpoint.place), viewpoint.targets.front());
            lookAround(tour, viewpoint.targets);
        }

    const auto steps = tour.smoothed();
    const Shake x(random), y(random), z(random), yaw(random), pitch(random), roll(random);
    const float angle = o.shakeRotation * DEG;
    for (int i = 0; i < o.frames; ++i) {
        const float share =
            o.frames > 1 ? static_cast<float>(i) / static_cast<float>(o.frames - 1) : 0.5F;
        const float at = share * static_cast<float>(steps.size() - 1);
        const auto k = std::min(static_cast<size_t>(at), steps.size() - 1);
        const Step a = steps[k], b = steps[std::min(k + 1, steps.size() - 1)];
        const float part = at - static_cast<float>(k), t = static_cast<float>(i) / o.frameRate;
        const auto between = [&](float from, float to) { return from + part * (to - from); };
        m_poses.emplace_back(
            between(a.x, b.x) + o.shakeTranslation * x.at(t),
            between(a.y, b.y) + o.shakeTranslation * y.at(t),
            o.carryHeight + 0.1F * std::sin(20 * share) + o.shakeTranslation * z.at(t),
            std::remainder(between(a.yaw, b.yaw) + angle * yaw.at(t), 2 * PI),
            -between(a.pitch, b.pitch) + angle * pitch.at(t),  // MRPT: down is +
            angle * roll.at(t));
    }
}
}  // namespace voxeland::simulation
