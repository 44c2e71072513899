// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/NoisyDetector.h"

#include "MaskDistortion.h"

#include <algorithm>

namespace voxeland::simulation
{
namespace
{
constexpr int MIN_MASK = 12;  //!< smaller masks are never reported [pixels]

/** Rises from 0 to 1, being a half at `half`. */
float saturating(float x, float half)
{
    const float square = x * x;
    return square > 0 ? square / (square + half * half) : 0.0F;
}
}  // namespace

/** Everything that happens in one image. */
class NoisyDetector::Frame
{
 public:
    Frame(const NoisyDetector& detector, const RenderedView& view, const mrpt::math::TPose3D& pose,
          Random& random)
        : m_detector(detector),
          m_options(detector.m_options),
          m_view(view),
          m_from(CameraFrame(pose).origin),
          m_random(random),
          m_seen(detector.visibility(view, pose)),
          m_covered(m_seen.size(), false)
    {
    }

    std::vector<InstancePrediction> run()
    {
        for (const auto& object : m_detector.m_scene.objects()) detect(object.id);
        for (int n = m_random.poisson(m_options.falseDetections); n > 0; --n) imagine();
        std::stable_sort(m_result.begin(), m_result.end(),
                         [](const auto& a, const auto& b) { return a.score > b.score; });
        return std::move(m_result);
    }

 private:
    void detect(ObjectId id)
    {
        const Visibility& seen = m_seen[id - 1U];
        if (seen.pixels < MIN_MASK || m_covered[id - 1U]) return;
        const float probability = m_detector.detectionProbability(seen);
        if (!m_random.chance(probability)) return;

        const float quality = 0.6F + 0.4F * probability / m_options.detectionRate;
        Bitmap mask = exactMask(id);
        swallow(id, mask);
        std::vector<Bitmap> pieces{mask};
        if (m_random.chance(m_options.splitting)) {
            pieces = cutInTwo(mask, m_random);
        } else if (m_random.chance(m_options.overSegmentation)) {
            pieces = cutInTwo(mask, m_random);
            pieces.pop_back();
        }
        for (const auto& piece : pieces)
            report(id, piece, m_detector.m_recognition.recognize(id, m_from, m_random), quality);
        if (m_random.chance(m_options.duplicates))
            report(id, mask, m_detector.m_recognition.mistake(id, m_random), 0.75F * quality);
    }

    /** Lets the mask of an object also cover what it should not. */
    void swallow(ObjectId id, Bitmap& mask)
    {
        for (const auto& other : m_detector.m_scene.objects())
            if (other.standsOn == id && m_random.chance(m_options.swallowing))
                cover(other.id, mask);

        std::vector<ObjectId> neighbours;
        for (const ObjectId other : m_detector.m_touching[id - 1U])
            if (m_detector.m_scene.object(other).standsOn != id && m_seen[other - 1U].pixels > 0)
                neighbours.push_back(other);
        if (neighbours.empty() || !m_random.chance(m_options.underSegmentation)) return;
        const ObjectId other =
            neighbours[static_cast<size_t>(m_random.below(static_cast<int>(neighbours.size())))];
        cover(other, mask);
        // Of two overlapping detections of one category a real detector suppresses one.
        const auto& scene = m_detector.m_scene;
        if (scene.object(id).category == scene.object(other).category) m_covered[other - 1U] = true;
    }

    /** A detection of nothing: a random ellipse. */
    void imagine()
    {
        const RenderCamera& camera = m_detector.m_camera;
        const float rx = m_random.uniform(10, 70) * camera.scale(),
                    ry = m_random.uniform(10, 70) * camera.scale();
        const float cx = m_random.uniform(0, static_cast<float>(camera.width)),
                    cy = m_random.uniform(0, static_cast<float>(camera.height));
        Bitmap mask{camera.width, camera.height, std::vector<uint8_t>(camera.pixels(), 0)};
        size_t i = 0;
        for (int v = 0; v < camera.height; ++v)
            for (int u = 0; u < camera.width; ++u, ++i) {
                const float x = (static_cast<float>(u) - cx) / rx,
                            y = (static_cast<float>(v) - cy) / ry;
                mask.pixels[i] = x * x + y * y < 1 ? 1 : 0;
            }
        const auto categories = m_detector.m_recognition.imagine(m_random);
        report(STRUCTURE, mask, categories, m_random.uniform(0.5F, 0.9F));
    }

    void report(ObjectId id, const Bitmap& exact, const CategoryDistribution& categories,
                float quality)
    {
        const Bitmap mask = distorted(exact, m_options, m_detector.m_camera.scale(), m_random);
        InstancePrediction prediction;
        const float best = categories.front().probability;
        const float noise = m_random.normal(std::min(0.05F, 0.05F * m_options.logitNoise));
        prediction.score = std::clamp(best * quality + noise, 0.0F, 1.0F);
        if (prediction.score < m_options.scoreThreshold || mask.area() < MIN_MASK) return;
        prediction.mask = RunLengthMask::fromBitmap(mask.pixels.data(), mask.width, mask.height);
        prediction.box = prediction.mask.boundingBox();
        prediction.categories = categories;
        if (m_options.tracks && id != STRUCTURE) prediction.track = id;
        m_result.push_back(std::move(prediction));
    }

    [[nodiscard]] Bitmap exactMask(ObjectId id) const
    {
        const RenderCamera& camera = m_detector.m_camera;
        Bitmap mask{camera.width, camera.height, std::vector<uint8_t>(camera.pixels(), 0)};
        cover(id, mask);
        return mask;
    }

    void cover(ObjectId id, Bitmap& mask) const
    {
        for (size_t i = 0; i < mask.pixels.size(); ++i)
            mask.pixels[i] = mask.pixels[i] | static_cast<uint8_t>(m_view.objects[i] == id);
    }

    const NoisyDetector& m_detector;
    const DetectorOptions& m_options;
    const RenderedView& m_view;
    Vector3 m_from;
    Random& m_random;
    std::vector<Visibility> m_seen;
    std::vector<bool> m_covered;  //!< objects swallowed by another detection
    std::vector<InstancePrediction> m_result;
};

NoisyDetector::NoisyDetector(const Scene& scene, const RenderCamera& camera,
                             const DetectorOptions& options, Random random)
    : m_scene(scene), m_camera(camera), m_options(options), m_recognition(scene, options, random)
{
    constexpr float POINTS_ALONG = 12;  // the longest side of an object
    for (const auto& object : scene.objects()) {
        const Vector3 size = object.bounds.size();
        const float spacing = std::max({size.x, size.y, size.z}) / POINTS_ALONG;
        m_surfaces.push_back(scene.sampleSurface(object.id, spacing));
        m_touching.push_back(scene.touching(object.id));
    }
}

std::vector<InstancePrediction> NoisyDetector::detect(const RenderedView& view,
                                                      const mrpt::math::TPose3D& pose,
                                                      Random random) const
{
    return Frame(*this, view, pose, random).run();
}

std::vector<NoisyDetector::Visibility> NoisyDetector::visibility(
    const RenderedView& view, const mrpt::math::TPose3D& pose) const
{
    const CameraFrame frame(pose);
    std::vector<Visibility> result(m_surfaces.size());
    for (const ObjectId id : view.objects)
        if (id != STRUCTURE) ++result[id - 1U].pixels;
    for (size_t i = 0; i < m_surfaces.size(); ++i) {
        if (result[i].pixels == 0) continue;
        int facing = 0, visible = 0;
        for (const auto& point : m_surfaces[i]) {
            const Vector3 p = point.position - frame.origin;
            if (dot(p, point.normal) >= 0) continue;
            ++facing;
            const auto pixel = m_camera.project(frame, point.position);
            if (pixel && view.objects[pixel->index] == i + 1) ++visible;
        }
        // Hidden by the object itself does not count as hidden: rarely more than half is.
        if (facing > 0)
            result[i].share =
                std::min(1.0F, 1.3F * static_cast<float>(visible) / static_cast<float>(facing));
    }
    return result;
}

float NoisyDetector::detectionProbability(const Visibility& seen) const
{
    const float scale = m_camera.scale();
    const float area = static_cast<float>(seen.pixels) / (scale * scale);
    return m_options.detectionRate * saturating(area, m_options.halfRateArea) *
           (m_options.halfRateVisible > 0 ? saturating(seen.share, m_options.halfRateVisible) : 1);
}
}  // namespace voxeland::simulation
