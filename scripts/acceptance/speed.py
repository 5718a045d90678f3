"""The lines about speed: whole runs of map_images, files included."""

import json
import re

from acceptance.common import PLACES, PROGRAMS, ROOT, Line, Skipped, dataset, fresh_folder, run
from acceptance.drives import image_list
from comparison.measuring import error_of, measure

STRIDE = {"every": 4, "parallax": 1}
WANTED = {"every": 7, "parallax": 25}  # images a second, on two idle cores
MAX_ERROR_CM = 1.2
MAX_GROWTH = 1.2
FAST = ("--frontend", ROOT / "config/frontend_fast.yaml")


def mapped(mode, stride, name, *options):
    """Images a second, what else is reported, and whether memory and map are in order."""
    source = dataset("tum_fr1_xyz")
    num_images = len(image_list(source)[::stride])
    out = fresh_folder(f"speed/{mode}_{name}")
    cost, _ = measure(PROGRAMS / "map_images", source, "--out", out, "--mode", mode, "--stride", stride, "--threads", 2,
                      "--no-store", *PLACES, *options)
    summary = json.loads((out / "summary.json").read_text())
    error_cm = 100 * error_of(PROGRAMS / "evaluate_trajectory", source / "groundtruth.txt", out / "trajectory.txt")
    rate = num_images / cost.wall_s
    sound = cost.peak_mb <= 2048 and error_cm <= MAX_ERROR_CM and summary["registered"] >= 0.95 * summary["frames"]
    return rate, sound, (f"{rate:.1f} images a second, {1000 * cost.cpu_s / num_images:.0f} ms of CPU each, "
                         f"{error_cm:.2f} cm, {summary['registered']} of {num_images}, peak {cost.peak_mb:.0f} MB")


def speed(mode):
    """The fast frontend is judged; what the options as they come do is told beside it."""
    def check(quick):
        stride = 8 if quick else STRIDE[mode]
        rate, sound, text = mapped(mode, stride, "fast", *FAST)
        _, _, by_default = mapped(mode, stride, "default")
        return rate >= WANTED[mode] and sound, f"{text}; with the default options {by_default}"
    return check


def growth(_quick):
    """What a picture costs at the end of a drive, beside early ones."""
    program = PROGRAMS / "picture_cost"
    if not program.exists():
        raise Skipped("picture_cost is not built")
    said = run(program, dataset("tum_fr1_xyz"))
    line = re.search(r"(?m)^the last \d+ pictures: .* (\d+\.\d+) times as much .*$", said)
    return float(line[1]) <= MAX_GROWTH, line[0]


LINES = [
    Line("speed_every", f"tum_fr1_xyz every 4th, mode every, config/frontend_fast.yaml: >= {WANTED['every']} images a second, "
         f"<= 2 GiB, <= {MAX_ERROR_CM} cm", speed("every"), False),
    Line("speed_parallax", f"tum_fr1_xyz, mode parallax, config/frontend_fast.yaml: >= {WANTED['parallax']} images a second, "
         f"<= 2 GiB, <= {MAX_ERROR_CM} cm", speed("parallax"), False),
    Line("growth", f"tum_fr1_xyz, mode every: the last 200 pictures cost <= {MAX_GROWTH} x those from 201 to 400", growth, False),
]
