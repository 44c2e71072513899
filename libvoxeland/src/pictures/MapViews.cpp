// SPDX-License-Identifier: BSD-3-Clause
#include "MapViews.h"

#include "Compositor.h"
#include "Figure.h"
#include "ViewColoring.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/level/UpDirection.h"

#include <opencv2/imgcodecs.hpp>

namespace voxeland
{
namespace
{
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

    const VoxelScene scene(map, GravityAlignedFrame(options.up ? *options.up : estimateUp(map)));
    const cv::Size picture = Figure::pictureSize(options.height);
    const cv::Size fine = picture * OVERSAMPLING;
    const double azimuth = bestAzimuth(scene, picture);
    const auto fromAbove = ViewCamera::top(scene, picture);
    const auto fromCorner = ViewCamera::perspective(scene, picture, azimuth);
    const Sight above(scene, ViewCamera::top(scene, fine), fine);
    const Sight corner(scene, ViewCamera::perspective(scene, fine, azimuth), fine);

    MapViews views;
    views.azimuth = azimuth;
    forEachColoring(map, scene, [&](const ViewColoring& coloring) {
        for (const bool top : {true, false}) {
            const ViewCamera& camera = top ? fromAbove : fromCorner;
            const std::string title = coloring.title + (top ? " (top view)" : " (perspective)");
            Figure sheet(options.height);
            sheet.drawTitle(title);
            sheet.drawPicture(composite(top ? above : corner, coloring.colors));
            sheet.drawLabels(coloring.labels, camera);
            if (top) sheet.drawScale(camera.pixelsPerMetre());
            sheet.drawAxes(scene, camera);
            sheet.drawLegend(coloring);
            views.pictures.push_back(
                {coloring.name + (top ? "_top" : "_perspective"), title, pngOf(sheet.image())});
        }
    });
    return views;
}

void exportViews(const SemanticVoxelMap& map, const std::string& folder, WrittenFiles& written,
                 const ViewOptions& options)
{
    const MapViews views = drawViews(map, options);
    makeOutputFolder(folder);
    for (const MapViews::Picture& picture : views.pictures) {
        const std::string file = folder + "/" + picture.name + ".png";
        writeAtomically(file, [&](std::ostream& out) {
            out.write(reinterpret_cast<const char*>(picture.png.data()),
                      static_cast<std::streamsize>(picture.png.size()));
        });
        written.add(file);
    }
}
}  // namespace voxeland
