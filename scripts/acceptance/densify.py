"""The lines about densifying (issue 11, part 1)."""

import json

from acceptance.common import NOISE, ROOT, WORK, Line, dataset, map_images, render_tour, run
from acceptance.dense import true_surface

MIN_GROWTH, MIN_ACCURATE = 2.0, 0.90
MIN_POINTS, MIN_PROJECTIONS, MAX_RMS_N = 37032, 152888, 0.83  # thesis, Table 5.7


def visionlab(quick):
    del quick
    tour = render_tour("visionlab", NOISE, 1)
    counts = map_images("densify/visionlab", [tour], "--densify")["densified"]
    out = WORK / "densify/visionlab"
    figures = json.loads(run(ROOT / "scripts/evaluate_cloud.py", out / "densified.ply", out / "trajectory.txt",
                             tour / "groundtruth.txt", true_surface("visionlab"),
                             "--added-from", counts["landmarks_before"], "--json"))
    holds = (counts["landmarks"] >= MIN_GROWTH * counts["landmarks_before"]
             and figures["added_3_percent"] >= MIN_ACCURATE)
    return holds, (f"{counts['landmarks_before']} -> {counts['landmarks']} points, "
                   f"{100 * figures['added_3_percent']:.1f} % of the added ones within 3 % of their range")


def leuven(quick):
    del quick
    counts = map_images("densify/leuven", [dataset("leuven_castle")], "--features", 8000, "--densify")["densified"]
    holds = (counts["landmarks"] >= MIN_POINTS and counts["projections"] >= MIN_PROJECTIONS
             and counts["rms_n"] <= MAX_RMS_N)
    return holds, (f"{counts['landmarks_before']} -> {counts['landmarks']} points, "
                   f"{counts['projections_before']} -> {counts['projections']} projections, "
                   f"RMS_N {counts['rms_n_before']:.2f} -> {counts['rms_n']:.2f}")


LINES = [
    Line("densify", "visionlab: twice the points, and the added ones are true", visionlab, False),
    Line("densify_leuven", "leuven_castle: as many points as Table 5.7 has", leuven, False),
]
