// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/MapViews.h"

#include "ViewSheet.h"
#include "VoxelRaster.h"
#include "voxeland/errors.h"
#include "voxeland/io/AtomicFile.h"
#include "voxeland/io/OutputFolder.h"
#include "voxeland/io/UpDirection.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace voxeland
{
namespace
{
constexpr int OVERSAMPLING = 2;  //!< pixels drawn for one of the picture, along each side
constexpr float VEIL = 0.45F;    //!< opacity of *unknown* in front of an object

/** What a camera sees of a scene: the objects, and everything else. */
struct Sight
{
    Sight(const VoxelScene& scene, const ViewCamera& c, cv::Size image)
        : camera(c), objects(scene, c, image, true), background(scene, c, image, false)
    {
    }
    ViewCamera camera;
    VoxelRaster objects, background;
};

/** Number of pixels that show an object with nothing in front of it. */
int visibleObjectPixels(const Sight& sight)
{
    return cv::countNonZero(sight.objects.depth() < sight.background.depth());
}

/** From the corner that shows most of the objects; tried out in small. */
double bestAzimuth(const VoxelScene& scene, cv::Size image)
{
    const cv::Size small(image.width / 8, image.height / 8);
    double best = 0;
    int most = -1;
    for (int eighth = 1; eighth < 16; eighth += 2) {
        const double azimuth = eighth * CV_PI / 8;
        const auto camera = ViewCamera::perspective(scene, small, azimuth);
        const int pixels = visibleObjectPixels(Sight(scene, camera, small));
        if (pixels <= most) continue;
        most = pixels;
        best = azimuth;
    }
    return best;
}

cv::Vec3f lit(const VoxelRaster& raster, int row, int column, const ViewColoring& coloring)
{
    const Color& c = coloring.colors[static_cast<size_t>(raster.voxel()(row, column))];
    return cv::Vec3f(c.blue, c.green, c.red) * raster.light()(row, column);
}

/** The picture that a colouring makes of what is seen. */
cv::Mat3b paint(const Sight& sight, const ViewColoring& coloring)
{
    cv::Mat3b picture(sight.objects.voxel().size(), cv::Vec3b(255, 255, 255));
    for (int row = 0; row < picture.rows; ++row)
        for (int column = 0; column < picture.cols; ++column) {
            const bool object = sight.objects.voxel()(row, column) != VoxelRaster::NOTHING;
            const bool other = sight.background.voxel()(row, column) != VoxelRaster::NOTHING;
            if (!object && !other) continue;
            const cv::Vec3f front =
                object ? lit(sight.objects, row, column, coloring) : cv::Vec3f();
            if (!other) {
                picture(row, column) = front;
                continue;
            }
            const cv::Vec3f back = lit(sight.background, row, column, coloring);
            const bool veiled =
                sight.background.depth()(row, column) < sight.objects.depth()(row, column);
            if (!object)
                picture(row, column) = back;
            else
                picture(row, column) = veiled ? front * (1 - VEIL) + back * VEIL : front;
        }
    cv::Mat3b fine;
    cv::resize(picture, fine, picture.size() / OVERSAMPLING, 0, 0, cv::INTER_AREA);
    return fine;
}

std::vector<uint8_t> pngOf(const cv::Mat3b& image)
{
    std::vector<uint8_t> bytes;
    cv::imencode(".png", image, bytes);
    return bytes;
}
}  // namespace

MapViews drawViews(const SemanticVoxelMap& map, const ViewOptions& options)
{
    constexpr int LEAST_HEIGHT = 200, GREATEST_HEIGHT = 8000;
    if (options.height < LEAST_HEIGHT || options.height > GREATEST_HEIGHT)
        throw ConfigurationError("pictures must be 200 to 8000 pixels high");
    if (options.up && !(options.up->norm() > 0))
        throw ConfigurationError("the up direction must not be 0,0,0");

    const VoxelScene scene(map, LevelFrame(options.up ? *options.up : estimateUp(map)));
    const cv::Size picture = ViewSheet::pictureSize(options.height);
    const cv::Size fine = picture * OVERSAMPLING;
    const double azimuth = bestAzimuth(scene, picture);
    const auto fromAbove = ViewCamera::top(scene, picture);
    const auto fromCorner = ViewCamera::perspective(scene, picture, azimuth);
    const Sight above(scene, ViewCamera::top(scene, fine), fine);
    const Sight corner(scene, ViewCamera::perspective(scene, fine, azimuth), fine);

    MapViews views;
    views.azimuth = azimuth;
    for (const ViewColoring& coloring : colorings(map, scene))
        for (const bool top : {true, false}) {
            const ViewCamera& camera = top ? fromAbove : fromCorner;
            const std::string title = coloring.title + (top ? " (top view)" : " (perspective)");
            ViewSheet sheet(options.height);
            sheet.drawTitle(title);
            sheet.drawPicture(paint(top ? above : corner, coloring));
            sheet.drawLabels(coloring.labels, camera);
            if (top) sheet.drawScale(camera.pixelsPerMetre());
            sheet.drawAxes(scene, camera);
            sheet.drawLegend(coloring);
            views.pictures.push_back(
                {coloring.name + (top ? "_top" : "_perspective"), title, pngOf(sheet.image())});
        }
    return views;
}

std::vector<std::string> exportViews(const SemanticVoxelMap& map, const std::string& folder,
                                     const ViewOptions& options)
{
    const MapViews views = drawViews(map, options);
    makeOutputFolder(folder);
    std::vector<std::string> files;
    for (const MapViews::Picture& picture : views.pictures) {
        files.push_back(folder + "/" + picture.name + ".png");
        writeAtomically(files.back(), [&](std::ostream& out) {
            out.write(reinterpret_cast<const char*>(picture.png.data()),
                      static_cast<std::streamsize>(picture.png.size()));
        });
    }
    return files;
}
}  // namespace voxeland
