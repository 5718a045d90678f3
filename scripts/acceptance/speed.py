"""The lines about speed: whole runs of map_images, files included."""

from acceptance.common import PLACES, PROGRAMS, Line, dataset, fresh_folder
from acceptance.drives import image_list
from comparison.measuring import measure

STRIDE = {"every": 4, "parallax": 1}
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


LINES = [
    Line("speed_every", f"tum_fr1_xyz every 4th, mode every: >= {WANTED['every']} images a second, <= 2 GiB", speed("every"),
         False),
    Line("speed_parallax", f"tum_fr1_xyz, mode parallax: >= {WANTED['parallax']} images a second, <= 2 GiB",
         speed("parallax"), False),
]
