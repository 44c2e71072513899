# SPDX-License-Identifier: BSD-3-Clause
"""Good inputs, damaged at random: cut off, overwritten, repeated, with numbers of another size."""
import gzip
import random
from pathlib import Path

from judge import Case

TERRIBLE = [b"nan", b"inf", b"-1", b"0", b"1e308", b"9e480", b"1e-320", b"99999999999999999999", b"",
            b"\x1b[2J", b"\xff\xfe", b"</script>", b"[" * 5000, b"x" * 60000, b"\n" * 2000, b"\0"]

MAP = ["rawlog2voxeland", "-o", "out.voxeland", "--set", "map.resolution=0.1", "--quiet"]
IMPORT = ["rgbd2rawlog", "--quiet", "-o", "out.rawlog"]
TRUTH = ["voxeland-eval", "-m", "map.voxeland", "--gt"]

# file to damage, and the commands that read it
READERS = [
    ("map.voxeland", [["voxeland-info", "map.voxeland", "--instances"],
                      ["voxeland-export", "-m", "map.voxeland", "--json", "out.json", "--glb", "out.glb"],
                      MAP + ["-i", "sim.rawlog", "--resume", "map.voxeland"],
                      ["voxeland-disambiguate", "-m", "map.voxeland", "-o", "out.voxeland", "--undo", "all"]]),
    ("sim.rawlog", [MAP + ["-i", "sim.rawlog"],
                    ["rawlog-add-instances", "-i", "sim.rawlog", "--coco", "coco.json", "-o", "out.rawlog"]]),
    ("sim.instances.rawlog", [MAP + ["-i", "sim.rawlog"]]),
    ("coco.json", [["rawlog-add-instances", "-i", "sim.rawlog", "--coco", "coco.json", "-o", "out.rawlog"]]),
    ("names.csv", [["rawlog-add-instances", "-i", "sim.rawlog", "--coco", "coco.json", "--categories",
                    "names.csv", "-o", "out.rawlog"]]),
    ("my.ini", [MAP + ["-i", "sim.rawlog", "-c", "my.ini"],
                ["rawlog2voxeland", "-c", "my.ini", "--dump-config"]]),
    ("truth/trajectory.tum", [MAP + ["-i", "sim.rawlog", "--poses", "truth/trajectory.tum"]]),
    ("truth/ground_truth.ply", [TRUTH + ["truth"]]),
    ("truth/categories.csv", [TRUTH + ["truth"]]),
    ("timing.csv", [["voxeland-report", "-m", "map.voxeland", "-o", "out.html", "--timing", "timing.csv"]]),
    ("scene.sens", [IMPORT + ["--format", "scannet", "--input", "scene.sens"]]),
    ("scene/seq-01/frame-000001.color.png", [IMPORT + ["--format", "7scenes", "--input", "scene"]]),
    ("scene/seq-01/frame-000001.depth.png", [IMPORT + ["--format", "7scenes", "--input", "scene"]]),
    ("scene/seq-01/frame-000001.pose.txt", [IMPORT + ["--format", "7scenes", "--input", "scene"]]),
    ("freiburg1_small/rgb.txt", [IMPORT + ["--format", "tum", "--input", "freiburg1_small"]]),
    ("freiburg1_small/groundtruth.txt", [IMPORT + ["--format", "tum", "--input", "freiburg1_small"]]),
    ("scenenn/011.xml", [TRUTH + ["scenenn", "--format", "scenenn"]]),
    ("scenenn/011.ply", [TRUTH + ["scenenn", "--format", "scenenn"]]),
]


def damaged(content, dice):
    """Some bytes of a file, changed for the worse."""
    at = dice.randrange(len(content) + 1)
    until = min(len(content), at + dice.choice([1, 2, 4, 8, 100, 5000]))
    how = dice.randrange(6)
    if how == 0:
        return content[:at]
    if how == 1:
        return content[:at] + bytes(dice.randrange(256) for _ in range(until - at)) + content[until:]
    if how == 2:
        return content[:at] + dice.choice([b"\0", b"\xff", b"\x7f", b"\x80"]) * (until - at) + content[until:]
    if how == 3:
        return content[:until] + content[at:until] * dice.choice([1, 3, 100]) + content[until:]
    if how == 4:
        return content[:at] + dice.choice(TERRIBLE) + content[until:]
    flipped = bytearray(content)
    for _ in range(dice.randrange(1, 20)):
        if flipped:
            flipped[dice.randrange(len(flipped))] ^= 1 << dice.randrange(8)
    return bytes(flipped)


def overwrite(file, content):
    path = Path(file)
    path.unlink()
    path.write_bytes(content)


def cases(good, count, seed):
    dice = random.Random(seed)
    result = []
    for i in range(count):
        file, commands = READERS[i % len(READERS)]
        command = dice.choice(commands)
        original = (good / file).read_bytes()
        isCompressed = original[:2] == b"\x1f\x8b"
        if isCompressed and dice.random() < 0.7:
            content = gzip.compress(damaged(gzip.decompress(original), dice), 1)
        else:
            content = damaged(original, dice)
        output = next((a for a in command if a.startswith("out.")), None)
        result.append(Case(f"{file} {seed}/{i}", command,
                           lambda file=file, content=content: overwrite(file, content), output,
                           mayHaveSaved=command[0] == "voxeland-export"))
    return result
