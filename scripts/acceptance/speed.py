"""The lines about speed: whole runs of map_images, files included."""

import re

from acceptance.common import PLACES, PROGRAMS, Line, Skipped, dataset, fresh_folder, run
from acceptance.drives import image_list
from comparison.measuring import measure

STRIDE = {"every": 4, "parallax": 1}
GROWTH_PICTURES, MAX_GROWTH = 500, 1.2
WANTED = {"every": 7, "parallax": 25}  # images a second, on two idle cores


def speed(mode):
    def check(quick):
        stride = 8 if quick else STRIDE[mode]
        source = dataset("tum_fr1_xyz")
        num_images = len(image_list(source)[::stride])
        cost, _ = measure(PROGRAMS / "map_images", source, "--out", fresh_folder(f"speed/{mode}"), "--mode", mode,
                          "--stride", stride, "--threads", 2, "--no-store", *PLACES)
        rate = num_images / cost.wall_s
        return rate >= WANTED[mode] and cost.peak_mb <= 2048, (
            f"{rate:.1f} images a second ({num_images} images), {1000 * cost.cpu_s / num_images:.0f} ms of CPU each, "
            f"peak {cost.peak_mb:.0f} MB")
    return check


def growth(_quick):
    """What a picture costs late in a drive, beside early ones."""
    program = PROGRAMS / "picture_cost"
    if not program.exists():
        raise Skipped("picture_cost is not built")
    said = run(program, dataset("tum_fr1_xyz"), GROWTH_PICTURES)
    costs_ms = [int(cost) for cost in re.findall(r"(?m)^pictures \d+ to \d+: median (\d+) ms", said)]
    return costs_ms[-1] <= MAX_GROWTH * costs_ms[1], (
        "median CPU ms of a picture, by hundreds: " + ", ".join(map(str, costs_ms)))


LINES = [
    Line("speed_every", f"tum_fr1_xyz every 4th, mode every: >= {WANTED['every']} images a second, <= 2 GiB", speed("every"),
         False),
    Line("speed_parallax", f"tum_fr1_xyz, mode parallax: >= {WANTED['parallax']} images a second, <= 2 GiB",
         speed("parallax"), False),
    Line("growth", f"tum_fr1_xyz, mode every: pictures 401 to 500 cost <= {MAX_GROWTH} x those from 101 to 200", growth,
         False),
]
