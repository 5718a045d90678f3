"""The lines about dense clouds and surfaces (issue 11, parts 2 and 3)."""

import functools
import json

from acceptance.common import NOISE, PROGRAMS, ROOT, WORK, Line, fresh_folder, map_images, render_tour, run
from comparison.measuring import measure as measure_cost

MIN_COMPLETE, MIN_ACCURATE = 0.60, 0.90
MAX_S_PER_KEYFRAME = 1.0  # of one core
MAX_MEDIAN_M, MIN_MESH_COMPLETE, MAX_FARTHEST_M = 0.02, 0.90, 0.10
OBJECT = "pile_"  # what turntable drives round


@functools.lru_cache(maxsize=None)
def dense_files(tour):
    """(folder, trajectory's folder, keyframes, CPU seconds) of a tour's dense cloud and mesh."""
    name = f"dense/{tour}"
    summary = map_images(name, [render_tour(tour, NOISE, 1)], "--keep-images")
    out = fresh_folder(f"{name}_files")
    export = (PROGRAMS / "map_tool", "export", WORK / name / "map.db", "--out", out, "--format")
    cost, _ = measure_cost(*export, "dense")
    run(*export, "mesh")
    return out, WORK / name, summary["registered_keyframes"], cost.cpu_s


@functools.lru_cache(maxsize=None)
def true_surface(tour):
    path = WORK / f"dense/{tour}_surface.ply"
    path.parent.mkdir(parents=True, exist_ok=True)
    run(PROGRAMS / "rovio_sim", "--surface", tour, "--camera", "plain", "--seed", 1, "--out", path, "--overwrite")
    return path


def measure(tour, file, *options):
    folder, mapped, *_ = dense_files(tour)
    trajectory = next(iter(sorted(mapped.rglob("trajectory.txt"))))
    return json.loads(run(ROOT / "scripts/evaluate_cloud.py", folder / file, trajectory,
                          render_tour(tour, NOISE, 1) / "groundtruth.txt", true_surface(tour), "--json", *options))


def depth(tour, quick):
    del quick
    figures = measure(tour, "dense.ply")
    _, _, keyframes, seconds = dense_files(tour)
    holds = (figures["completeness_5cm"] >= MIN_COMPLETE and figures["accuracy_5cm"] >= MIN_ACCURATE
             and seconds / keyframes <= MAX_S_PER_KEYFRAME)
    return holds, (f"{figures['points']} points, {100 * figures['completeness_5cm']:.1f} % of the surface with contrast "
                   f"({100 * figures['completeness_5cm_whole']:.1f} % of all), {100 * figures['accuracy_5cm']:.1f} % of "
                   f"the points within 5 cm, {seconds / keyframes:.2f} s a keyframe")


def mesh(quick):
    del quick
    figures = measure("turntable", "mesh.ply", "--objects", OBJECT)
    holds = (figures["accuracy_median_m"] <= MAX_MEDIAN_M and figures["completeness_5cm_objects"] >= MIN_MESH_COMPLETE
             and figures["farthest_m"] <= MAX_FARTHEST_M)
    return holds, (f"median {100 * figures['accuracy_median_m']:.1f} cm, farthest {100 * figures['farthest_m']:.1f} cm, "
                   f"{100 * figures['completeness_5cm_objects']:.1f} % of the object's surface within 5 cm "
                   f"({100 * figures['completeness_5cm']:.1f} % of all that the room shows)")


LINES = [
    Line("depth_visionlab", "depth maps of visionlab: complete, true, fast",
         functools.partial(depth, "visionlab"), False),
    Line("depth_engineRoom0", "depth maps of engineRoom0: complete, true, fast",
         functools.partial(depth, "engineRoom0"), False),
    Line("mesh_turntable", "the Poisson surface of turntable lies on the true one", mesh, False),
]
