# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that pages show commands for and that their own commands cannot make."""
import json
import shutil
import subprocess

FRAMES = 12  # of the kitchen
SIMULATED = 4


def redkitchen(folder, data):
    """The first frames of the real kitchen, and what a network said about them in coco.json."""
    scene = data / "7scenes_redkitchen"
    if not scene.is_dir():
        return False
    sequence = folder / "redkitchen" / "seq-01"
    sequence.mkdir(parents=True, exist_ok=True)
    shutil.copy(scene / "camera-intrinsics.txt", folder / "redkitchen")
    for number in range(FRAMES):
        for file in (scene / "seq-01").glob(f"frame-{number:06d}.*"):
            shutil.copy(file, sequence)
    predictions = json.loads((scene / "predictions_coco.json").read_text(encoding="utf-8"))
    kept = [p for p in predictions if p["image_id"] < FRAMES]
    (folder / "coco.json").write_text(json.dumps(kept), encoding="utf-8")
    return True


def robot(folder, _):
    """A rawlog without predictions, robot.rawlog; some, coco.json; its trajectory, robot.tum."""
    subprocess.run(["voxeland-simulate", "-o", "robot.rawlog", "--gt", "robot_truth", "--rooms", "1",
                    "--frames", str(SIMULATED), "--width", "160", "--height", "120", "--quiet"],
                   cwd=folder, check=True, capture_output=True)
    (folder / "robot.instances.rawlog").unlink()
    shutil.copy(folder / "robot_truth" / "trajectory.tum", folder / "robot.tum")
    square = {"segmentation": [[40, 30, 120, 30, 120, 90, 40, 90]], "score": 0.8, "category_id": 62}
    (folder / "coco.json").write_text(
        json.dumps([{"image_id": number, **square} for number in range(SIMULATED)]), encoding="utf-8")
    return True


def network(folder, data):
    """A real network, and a rawlog for it to look at."""
    model = data / "models" / "yolov8n-seg.onnx"
    if not model.is_file():
        return False
    link = folder / model.name
    if not link.exists():
        link.symlink_to(model)
    return robot(folder, data)


MAKERS = {"redkitchen": redkitchen, "robot": robot, "yolov8n-seg.onnx": network}


def provided(need, folder, data):
    """Makes an input, or finds a program. \\return whether it is there"""
    if need in MAKERS:
        return MAKERS[need](folder, data)
    return shutil.which(need) is not None
