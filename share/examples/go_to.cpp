// SPDX-License-Identifier: BSD-3-Clause
// "Go to the nearest couch": a path by MRPT's planner, in the frame of exported gridmaps.
#include <voxeland/answers/MapAnswers.h>
#include <voxeland/level/UpDirection.h>
#include <voxeland/map/CategorySearch.h>
#include <voxeland/map/SmallInstances.h>
#include <voxeland/metric_map/CVoxelandMap.h>
#include <voxeland/metric_map/MapFile.h>
#include <voxeland/planning/DrivableFloor.h>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/nav/planners/PlannerSimple2D.h>

#include <iostream>
#include <sstream>

using mrpt::maps::COccupancyGridMap2D, mrpt::math::TPoint2D, mrpt::math::TPose2D;
const voxeland::DrivingRobot ROBOT;

struct Way
{
    TPose2D goal;
    std::deque<TPoint2D> points;  // from start to goal; empty: there is no way
    double length = INFINITY;     // [m]
};

Way plan(const COccupancyGridMap2D& grid, const TPoint2D& start, const TPose2D& goal)
{
    mrpt::nav::PlannerSimple2D planner;
    planner.robotRadius = static_cast<float>(ROBOT.radius);
    planner.minStepInReturnedPath = 0.2F;
    Way way{goal, {}, 0};
    bool none = true;
    planner.computePath(grid, {start.x, start.y, 0}, mrpt::poses::CPose2D(goal), way.points, none);
    if (none) return {};
    way.points.push_front(start);
    for (size_t i = 1; i < way.points.size(); ++i)
        way.length += (way.points[i] - way.points[i - 1]).norm();
    return way;
}

Way wayToNearest(const std::vector<voxeland::FoundInstance>& objects,
                 const voxeland::DrivableFloor& floor, const TPoint2D& start)
{
    Way best{{start.x, start.y, 0}, {}};
    for (const auto& object : objects)
        for (const TPose2D& pose : floor.posesFacing(object.box)) {
            const Way way = plan(floor.grid(), start, pose);
            if (way.length < best.length) best = way;
            if (!way.points.empty()) break;  // from where it is best seen
        }
    return best;
}

void draw(const COccupancyGridMap2D& grid, const Way& way, const std::string& file)
{
    constexpr unsigned ZOOM = 5;
    const double scale = ZOOM / grid.getResolution();  // [pixels/m]
    mrpt::img::CImage image;
    grid.getAsImage(image, false, true);
    image.scaleImage(image, ZOOM * grid.getSizeX(), ZOOM * grid.getSizeY());
    const auto x = [&](double meters) { return int(scale * (meters - grid.getXMin())); };
    const auto y = [&](double meters) { return int(scale * (grid.getYMax() - meters)); };
    for (size_t i = 1; i < way.points.size(); ++i) {
        const TPoint2D &a = way.points[i - 1], &b = way.points[i];
        image.line(x(a.x), y(a.y), x(b.x), y(b.y), {230, 60, 20}, 3);
    }
    const TPoint2D goal(way.goal), nose = way.goal.composePoint({ROBOT.radius, 0});
    image.drawCircle(x(goal.x), y(goal.y), int(scale * ROBOT.radius), {20, 90, 230}, 3);
    image.line(x(goal.x), y(goal.y), x(nose.x), y(nose.y), {20, 90, 230}, 3);
    if (!image.saveToFile(file)) throw std::runtime_error("cannot write " + file);
}

int main(int argc, char** argv)
try {
    TPoint2D start;
    std::istringstream xy(argc < 5 ? "" : argv[3] + std::string(" ") + argv[4]);
    if (!(xy >> start.x >> start.y)) throw std::runtime_error("usage: go_to MAP WHAT X Y [PNG]");
    const std::string what = argv[2];
    const auto file = voxeland::loadMap(argv[1]);
    voxeland::SemanticVoxelMap& map = file->editMap();
    voxeland::deactivateSmallInstances(map, 10);  // specks are no places to go to
    const auto objects = voxeland::findInstances(map, what, {start.x, start.y, 0});
    if (objects.empty()) {
        std::string known;
        for (const auto& c : voxeland::overviewOf(map, {}).categories)
            known += (known.empty() ? "" : ", ") + c.first;
        throw std::runtime_error(whyNoneIsFound(map, what) + "; it holds: " + known);
    }
    const voxeland::DrivableFloor floor(map, voxeland::GravityAlignedFrame(estimateUp(map)), ROBOT);
    if (!floor.fits(start)) throw std::runtime_error("the robot does not fit where it starts");
    const Way way = wayToNearest(objects, floor, start);
    if (argc > 5) draw(floor.grid(), way, argv[5]);
    if (way.points.empty()) throw std::runtime_error("no way to a place before any " + what);
    std::cout << "goal " << way.goal << ", " << way.length << " m away\n";
    for (const TPoint2D& p : way.points) std::cout << p.x << " " << p.y << "\n";
} catch (const std::exception& e) {
    std::cerr << "go_to: " << e.what() << "\n";
    return 1;
}
