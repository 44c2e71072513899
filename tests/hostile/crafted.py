# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that somebody thought of: wrong kinds of files, long words, deep nests, absurd numbers."""
import gzip
import json
import os
import struct
from pathlib import Path

from good_inputs import largePng
from judge import Case

LONG = "x" * 60000
SECRET = "sk-Secret-0123456789"
DEEP = "[" * 100000 + "]" * 100000
MAP = ["rawlog2voxeland", "-i", "sim.rawlog", "-o", "out.voxeland", "--quiet"]
ADD = ["rawlog-add-instances", "-i", "sim.rawlog", "-o", "out.rawlog", "--coco"]
INFO = ["voxeland-info", "map.voxeland"]
EXPORT = ["voxeland-export", "-m", "map.voxeland"]


def written(file, text):
    def prepare():
        Path(file).unlink(missing_ok=True)
        Path(file).parent.mkdir(parents=True, exist_ok=True)
        Path(file).write_bytes(text if isinstance(text, bytes) else text.encode())
    return prepare


def made(maker, name):
    return lambda: maker(name)


def specialFiles():
    """Anything that is no regular file, in the place of every input and output."""
    inputs = [["rawlog2voxeland", "-o", "out.voxeland", "-i", "IT"], MAP + ["-c", "IT"], MAP + ["--poses", "IT"],
              MAP + ["--resume", "IT"], ADD + ["IT"], ADD + ["coco.json", "--categories", "IT"],
              ["voxeland-info", "IT"], ["voxeland-export", "-m", "IT", "--json", "out.json"],
              ["voxeland-eval", "-m", "map.voxeland", "--gt", "IT"],
              ["voxeland-report", "-m", "map.voxeland", "-o", "out.html", "--timing", "IT"],
              ["rgbd2rawlog", "--format", "scannet", "--input", "IT", "-o", "out.rawlog"]]
    outputs = [["rawlog2voxeland", "-i", "sim.rawlog", "-o", "IT"], EXPORT + ["--ply", "IT"],
               EXPORT + ["--json", "IT"], ["voxeland-report", "-m", "map.voxeland", "-o", "IT"]]
    kinds = [("a FIFO", made(os.mkfifo, "it"), "it"), ("a folder", made(os.mkdir, "it"), "it"),
             ("an endless device", lambda: None, "/dev/zero"),
             ("a link to itself", lambda: os.symlink("it", "it"), "it"),
             ("an empty file", written("it", ""), "it")]
    return [Case(f"{kind} for {command[command.index('IT') - 1]} of {command[0]}",
                 [name if word == "IT" else word for word in command], prepare)
            for kind, prepare, name in kinds for command in inputs + outputs
            if not (command in outputs and kind == "an empty file")]


def words():
    options = [["rawlog2voxeland", "--check-config", "--set", LONG],
               ["rawlog2voxeland", "--check-config", "--set", "map." + LONG + "=1"],
               ["rawlog2voxeland", "--check-config", "--set", "map.resolution=" + "0" * 60000],
               ["rawlog2voxeland", "--check-config", "--set", "map.resolution=1e-320"],
               ["rawlog2voxeland", "--check-config", "--set", "map.\033[2Jfoo=1"],
               ["rawlog2voxeland", "--check-config", "--set", "association.class=" + LONG],
               ["rawlog2voxeland", "--" + LONG], INFO + ["--find", LONG], INFO + ["--at", "1,2," + LONG],
               INFO + ["--at", "nan,inf,1e308"], INFO + ["--explain", "99999999999999999999"],
               EXPORT + ["--gridmap", "out.gridmap", "--height", "0.1,1e308"],
               EXPORT + ["--gridmap", "out.gridmap", "--height", "nan,nan"],
               EXPORT + ["--ply", LONG], EXPORT + ["--json", "\033[31m/out.json"],
               ["voxeland-info", "\033]0;title\007.voxeland"]]
    return [Case(f"words {i}", command) for i, command in enumerate(options)]


def annotations():
    def entry(**changes):
        return json.dumps([dict({"image_id": 0, "category_id": 1, "score": 0.5,
                                 "segmentation": [[5, 5, 40, 5, 40, 40]]}, **changes)])
    huge = {"size": [30000, 35000], "counts": [0, 30000 * 35000]}
    files = {"nested deep": DEEP, "an object nested deep": '{"a":' * 100000, "a long number": "[" + "9" * 100000 + "]",
             "no number": "[9e480]", "a mask of a gigapixel": entry(segmentation=huge),
             "negative runs": entry(segmentation={"size": [60, 80], "counts": [-1, 5000]}),
             "endless runs": entry(segmentation={"size": [60, 80], "counts": [4294967295] * 1000}),
             "coordinates of 1e300": entry(segmentation=[[0, 0, 1e300, 0, 1e300, 1e300]]),
             "a score of text": entry(score=LONG), "a long category": entry(category_name=LONG),
             "control characters": entry(category_name="\033[2J\u202e</script>"),
             "an id of text": entry(image_id=LONG), "null": "null", "text": '"chair"', "nothing": "",
             "thousands of masks": json.dumps(json.loads(entry()) * 5000)}
    return [Case(f"coco, {name}", ADD + ["coco.json"], written("coco.json", text)) for name, text in files.items()]


def others():
    ply = "ply\nformat binary_little_endian 1.0\nelement vertex {}\n{}end_header\n"
    xyz = "".join(f"property float {c}\n" for c in "xyz") + "property int instance\nproperty int category\n"
    truth = ["voxeland-eval", "-m", "map.voxeland", "--gt", "truth"]
    scenenn = ["voxeland-eval", "-m", "map.voxeland", "--gt", "scenenn", "--format", "scenenn"]
    pose = "scene/seq-01/frame-000001.pose.txt"
    sevenScenes = ["rgbd2rawlog", "--format", "7scenes", "--input", "scene", "-o", "out.rawlog", "--quiet"]
    return [
        Case("ply, endless points", truth, written("truth/ground_truth.ply", ply.format(2**60, xyz))),
        Case("ply, endless nothings", truth, written("truth/ground_truth.ply", ply.format(
            1, xyz + "element nothing 18446744073709551615\n") + "\0" * 20)),
        Case("ply, a long word", truth, written("truth/ground_truth.ply", "ply\n" + LONG)),
        Case("ply, many properties", truth, written("truth/ground_truth.ply", ply.format(
            1, "".join(f"property float p{i}\n" for i in range(20000))))),
        Case("xml, no element", scenenn, written("scenenn/011.xml", '<?xml version="1.0"?>\n<!-- -->\n')),
        Case("xml, nested deep", scenenn, written("scenenn/011.xml", "<a>" * 100000)),
        Case("xml, a long name", scenenn, written("scenenn/011.xml", f'<annotation><label id="1" text="{LONG}"')),
        Case("ini, a long key", MAP + ["-c", "my.ini"], written("my.ini", f"[map]\n{LONG} = 1\n")),
        Case("ini, a long section", MAP + ["-c", "my.ini"], written("my.ini", f"[{LONG}]\na = 1\n")),
        Case("ini, a plugin that is none", MAP + ["-c", "my.ini"],
             written("my.ini", "[association]\nplugin = sim.rawlog\n")),
        Case("ini, a device as plugin", MAP + ["-c", "my.ini"],
             written("my.ini", "[association]\nplugin = /dev/zero\n")),
        Case("poses of 1e300", MAP + ["--poses", "p.tum"], written("p.tum", "1 1e300 0 0 0 0 0 1\n" * 3)),
        Case("times of 1e300", MAP + ["--poses", "p.tum"], written("p.tum", "1e300 0 0 0 0 0 0 1\n" * 3)),
        Case("a line of a megabyte", MAP + ["--poses", "p.tum"], written("p.tum", "1 " * 500000)),
        Case("names, 100,000", ADD + ["coco.json", "--categories", "names.csv"],
             written("names.csv", "".join(f"{i},c{i}\n" for i in range(100000)))),
        Case("pose of 1e300", sevenScenes, written(pose, "1e300 0 0 0\n" * 4)),
        Case("pose, a word of a megabyte", sevenScenes, written(pose, "1" * 1000000)),
        Case("camera, focal length 0", sevenScenes + ["--intrinsics", "0,0,40,30"]),
        Case("camera, focal length 1e300", sevenScenes + ["--intrinsics", "1e300,1e300,40,30"]),
        Case("camera, nan", sevenScenes + ["--intrinsics", "nan,60,40,30"]),
        Case("depth of 16 km", sevenScenes + ["--depth-scale", "1e-9"]),
        Case("resolution of a micrometre", MAP + ["--set", "map.resolution=1e-6"]),
        Case("far and fine", MAP + ["--set", "map.resolution=0.001", "--set", "voxeland.max_depth=60000"]),
    ]


def secrets():
    """What must not be shown: the environment's variables in an INI, keys in a wrong place."""
    os.environ["VOXELAND_HOSTILE_SECRET"] = SECRET
    it = "$env{VOXELAND_HOSTILE_SECRET}"
    ask = ["voxeland-disambiguate", "-m", "map.voxeland", "-i", "sim.rawlog", "-o", "out.voxeland", "-c", "my.ini"]
    chat = "[disambiguation]\nclass = CChatCompletionsDisambiguator\nbase_url = http://localhost:9/v1\nmodel = m\n"
    inis = {"a number": (MAP + ["-c", "my.ini"], f"[map]\nresolution = {it}\n"),
            "a class": (MAP + ["-c", "my.ini"], f"[association]\nclass = {it}\n"),
            "a library": (MAP + ["-c", "my.ini"], f"[association]\nclass = C\nplugin = {it}\n"),
            "a label": (MAP + ["-c", "my.ini"], f"[voxeland]\ndepth_sensor_label = {it}\n"),
            "a file of poses": (MAP + ["-c", "my.ini"], f"[voxeland]\npose_source = tum:{it}\n"),
            "all of it": (["rawlog2voxeland", "-c", "my.ini", "--dump-config"], f"{chat}system_message = {it}\n"),
            "a server": (ask, f"{chat}ca_file = {it}\nextra_body = {it}\n"),
            "a key as a name": (ask, f"{chat}api_key_env = {SECRET}\n"),
            "a key as a name to map": (MAP + ["-c", "my.ini"], f"{chat}api_key_env = {SECRET}\n")}
    key = ["--set", f"disambiguation.api_key={SECRET}"]
    return ([Case(f"secret, {name}", command, written("my.ini", text), secret=SECRET)
             for name, (command, text) in inis.items()]
            + [Case("secret, a key of no name", MAP + key, secret=SECRET)])


def configured(text):
    """A map that says to be configured so."""
    def prepare():
        content = gzip.decompress(Path("map.voxeland").read_bytes())
        begin = content.index(b"[voxeland]\n")
        (length,) = struct.unpack("<I", content[begin - 4:begin])
        Path("map.voxeland").unlink()
        Path("map.voxeland").write_bytes(gzip.compress(
            content[:begin - 4] + struct.pack("<I", len(text)) + text + content[begin + length:], 1))
    return prepare


def large(file, side):
    def prepare():
        Path(file).unlink()
        Path(file).write_bytes(largePng(side))
    return prepare


def endless():
    """Small or plain inputs that ask for much time or memory."""
    resume = MAP + ["--resume", "map.voxeland"]
    keys = b"[map]\n" + b"".join(b"k%d=1\n" % i for i in range(3000000))
    sections = b"".join(b"[s%d]\n" % i for i in range(2000000))
    bombs = ["scene/seq-01/frame-000001.depth.png", "scene/seq-01/frame-000000.color.png"]
    sevenScenes = ["rgbd2rawlog", "--format", "7scenes", "--input", "scene", "-o", "out.rawlog", "--quiet"]
    tum = ["rgbd2rawlog", "--format", "tum", "--input", "freiburg1_small", "-o", "out.rawlog", "--to", "2", "--quiet"]

    def repeated(kinds):
        def prepare():
            for kind in kinds:
                written(f"freiburg1_small/{kind}.txt", f"1000.0 {kind}/1000.0.png\n" * 60000)()
        return prepare
    spread = ["voxeland-export", "-m", "spread.voxeland"]
    return [
        Case("endless, keys of a map", resume, configured(keys), "out.voxeland"),
        Case("endless, sections of a map", resume, configured(sections), "out.voxeland"),
        Case("endless, times of TUM that repeat", tum, repeated(["rgb", "depth"])),
        Case("endless, poses of TUM that repeat", tum, written(
            "freiburg1_small/groundtruth.txt", "1000.0 0 0 1 0 0 0 1\n" * 300000)),
        Case("endless, a grid of a spread map", spread + ["--gridmap", "out.gridmap"]),
        Case("endless, a map for ROS of a spread map", spread + ["--ros-map", "out.yaml", "--height=-1000,1000"]),
    ] + [Case(f"endless, pixels of {file}", sevenScenes, large(file, 30000)) for file in bombs] + [
        Case("a class without objects", ["rawlog2voxeland", "-i", "it", "-o", "out.voxeland"], written(
            "it", b"\x97mrpt::obs::CObservation" + b"\x01" * 100)),
    ]


def cases():
    return specialFiles() + words() + annotations() + others() + secrets() + endless()
