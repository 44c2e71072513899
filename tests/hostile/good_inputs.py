# SPDX-License-Identifier: BSD-3-Clause
"""Small inputs of every kind that are right, made by the programs themselves or written here."""
import json
import struct
import subprocess
import zlib
from pathlib import Path

INI = """[voxeland]
max_depth = 5.5 // far
[map]
resolution = 0.1
entropy = paper
[association]
class = CIoUAssociation
tau_iou = 0.4
"""
CSV = 'id,name\n1,"dining table"\n2,cup\n'
COCO = {"images": [{"id": i, "file_name": f"{i}.png"} for i in range(4)],
        "categories": [{"id": 1, "name": "chair"}, {"id": 2, "name": "cup"}],
        "annotations": [{"image_id": i, "category_id": 1 + i % 2, "score": 0.5 + i / 10,
                         "segmentation": [[5, 5, 40, 5, 40, 40.5, 5, 40]]} for i in range(4)]}


def chunk(kind, data):
    """A part of a PNG."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, bits, value):
    """A grey PNG of one value."""
    row = b"\0" + struct.pack(">H" if bits == 16 else ">B", value) * width
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(row * height)) + chunk(b"IEND", b""))


def largePng(side):
    """A black PNG of 16 bits: its rows are packed once, and repeated."""
    rows = 100
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    portion = packer.compress(bytes((1 + 2 * side) * rows)) + packer.flush(zlib.Z_FULL_FLUSH)
    adler = ((1 + 2 * side) * side % 65521) << 16 | 1
    packed = b"\x78\x9c" + portion * (side // rows) + b"\x03\x00" + struct.pack(">I", adler)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 16, 0, 0, 0, 0))
            + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def sens(frames):
    """A .sens file of small frames: PNG colour, compressed depth."""
    matrix = struct.pack("<16f", *[1 if i % 5 == 0 else 0 for i in range(16)])
    camera = struct.pack("<16f", 60, 0, 40, 0, 0, 60, 30, 0, 0, 0, 1, 0, 0, 0, 0, 1)
    out = struct.pack("<IQ", 4, 4) + b"room" + camera + matrix + camera + matrix
    out += struct.pack("<iiIIIIfQ", 1, 1, 80, 60, 80, 60, 1000.0, frames)
    colour, depth = png(80, 60, 8, 100), zlib.compress(struct.pack("<H", 2000) * 80 * 60)
    for i in range(frames):
        out += matrix + struct.pack("<QQQQ", i * 33000, i * 33000, len(colour), len(depth)) + colour + depth
    return out + struct.pack("<Q", 0)


def sevenScenes(folder):
    sequence = folder / "seq-01"
    sequence.mkdir(parents=True)
    for i in range(3):
        stem = sequence / f"frame-{i:06d}"
        Path(f"{stem}.color.png").write_bytes(png(80, 60, 8, 90 + i))
        Path(f"{stem}.depth.png").write_bytes(png(80, 60, 16, 2000 + i))
        Path(f"{stem}.pose.txt").write_text("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")


def tum(folder):
    for kind in ("rgb", "depth"):
        (folder / kind).mkdir(parents=True)
        lines = []
        for i in range(3):
            name = f"{kind}/{1000 + i / 10:.1f}.png"
            (folder / name).write_bytes(png(80, 60, 8 if kind == "rgb" else 16, 100 + 9000 * (kind == "depth")))
            lines.append(f"{1000 + i / 10:.6f} {name}\n")
        (folder / f"{kind}.txt").write_text("# images\n" + "".join(lines))
    (folder / "groundtruth.txt").write_text(
        "".join(f"{999.9 + i / 10:.4f} {i / 100} 0 1 0 0 0 1\n" for i in range(6)))


def scenenn(folder):
    folder.mkdir()
    (folder / "011.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
        "property int label\nend_header\n0 0 0 1\n1 0 0 2\n")
    (folder / "011.xml").write_text('<annotation><label id="1" text="chair" nyu_class="chair"/>'
                                    '<label id="2" text="table" nyu_class="table"/></annotation>\n')


def spread(trajectory):
    """The poses of a trajectory, kilometres from each other."""
    poses = [line.split() for line in trajectory.splitlines() if not line.startswith("#")]
    return "".join(f"{p[0]} {3000 * i} {-7000 * i} {p[3]} {' '.join(p[4:])}\n" for i, p in enumerate(poses))


def makeGoodInputs(programs, folder):
    """Fills a folder. \\return it"""
    folder.mkdir()

    def made(*command):
        subprocess.run([str(programs / command[0])] + list(command[1:]), cwd=folder, check=True,
                       capture_output=True)
    made("voxeland-simulate", "-o", "sim.rawlog", "--gt", "truth", "--rooms", "1", "--frames", "4",
         "--width", "80", "--height", "60", "--quiet")
    made("rawlog2voxeland", "-i", "sim.rawlog", "-o", "map.voxeland", "--timing", "timing.csv",
         "--set", "map.resolution=0.1", "--quiet")
    (folder / "spread.tum").write_text(spread((folder / "truth/trajectory.tum").read_text()))
    made("rawlog2voxeland", "-i", "sim.rawlog", "-o", "spread.voxeland", "--poses", "spread.tum",
         "--set", "map.resolution=0.05", "--quiet")
    (folder / "my.ini").write_text(INI)
    (folder / "names.csv").write_text(CSV)
    (folder / "coco.json").write_text(json.dumps(COCO))
    (folder / "scene.sens").write_bytes(sens(3))
    sevenScenes(folder / "scene")
    tum(folder / "freiburg1_small")
    scenenn(folder / "scenenn")
    return folder
