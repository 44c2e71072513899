// SPDX-License-Identifier: BSD-3-Clause
// A program: how many objects a map holds.
#include <voxeland/answers/MapAnswers.h>
#include <voxeland/metric_map/CVoxelandMap.h>
#include <voxeland/metric_map/MapFile.h>

#include <exception>
#include <iostream>

int main(int argc, char** argv)
try {
    if (argc != 2) throw std::invalid_argument("usage: count_objects MAP.voxeland");
    const auto map = voxeland::loadMap(argv[1]);
    std::cout << voxeland::overviewOf(map->map(), map->counts()).instances << "\n";
    return 0;
} catch (const std::exception& e) {
    std::cerr << e.what() << "\n";
    return 1;
}
