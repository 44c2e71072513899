# SPDX-License-Identifier: BSD-3-Clause
"""No include runs from a room of the house to one on the same floor or above: see docs, "The house".

usage: no_include_runs_up.py FOLDER_OF_THE_SOURCES
"""
import pathlib
import re
import sys

FLOORS = [
    ["base", "evidence"],
    ["grid", "files"],
    ["map", "observations"],
    ["level", "plugins"],
    ["planning", "pictures", "pipeline"],
    ["exporters", "rawlogs"],
    ["answers", "metric_map", "datasets", "simulation"],
    ["report", "evaluation", "disambiguation"],
]


def room_of_include(target, own_room, top):
    """The room that holds the header of an include, or None if it is not of the library."""
    public = re.fullmatch(r"voxeland/(\w+)/\w+\.h", target)
    if public:
        return public[1]
    private = re.fullmatch(r"(\w+)/\w+\.h", target)
    if private and (top / "libvoxeland/src" / target).exists():
        return private[1]
    return own_room if "/" not in target else None


def arrows(top):
    """Every include between two rooms of the library: (file, room, included header, its room)."""
    for side in ("src", "include/voxeland"):
        for file in sorted((top / "libvoxeland" / side).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".in"):
                continue
            room = file.parent.name
            for target in re.findall(r'^#include "(.+?)"', file.read_text(), re.M):
                other = room_of_include(target, room, top)
                if other is not None and other != room:
                    yield file, room, target, other


def main():
    top = pathlib.Path(sys.argv[1])
    floor = {room: height for height, rooms in enumerate(FLOORS) for room in rooms}
    rooms = {path.name for path in (top / "libvoxeland/src").iterdir() if path.is_dir()}
    faults = [f"room {room} is on no floor" for room in sorted(rooms - floor.keys())]
    faults += [f"floor of {room}, which is no room" for room in sorted(floor.keys() - rooms)]
    count = 0
    for file, room, target, other in arrows(top):
        count += 1
        if floor.get(other, len(FLOORS)) >= floor.get(room, -1):
            faults.append(f"{file.relative_to(top)} ({room}) includes {target} ({other})")
    for plugin in sorted((top / "plugins").rglob("*.[ch]*")):
        for target in re.findall(r'^#include "(\w+)/', plugin.read_text(), re.M):
            if target in floor:
                faults.append(f"{plugin.relative_to(top)} includes a private header of {target}")
    print(f"{count} includes between {len(rooms)} rooms", *faults, sep="\n")
    sys.exit(1 if faults or count == 0 else 0)


main()
