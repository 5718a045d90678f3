#!/usr/bin/python3
"""Compares a dense cloud or a mesh of a rendered tour with the true surface, after one similarity of
the trajectories:
  evaluate_cloud.py CLOUD.ply TRAJECTORY.txt GROUNDTRUTH.txt SURFACE.ply
                    [--added-from N] [--by-range] [--objects PREFIX] [--json]
CLOUD: dense.ply, densified.ply or mesh.ply (its corners and points even over its triangles);
SURFACE: of rovio_sim --surface. Prints shares within 5 cm, the median and the farthest in metres; with N, of the
points from the N-th on also how many lie within 3 % of their range: the distance to the nearest
camera that has them in its picture (calibration.txt beside GROUNDTRUTH); --by-range: how much of
the wanted surface lies in each metre of range, and how much of that within 5 cm of a point;
--objects: how much of the wanted surface of the objects whose names begin so lies within 5 cm."""

import argparse
import json
import pathlib
import sys

import numpy
import open3d
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation
from scipy.special import erf

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import Unreadable, end_plainly, reads  # noqa: E402  (after the path is set)

NEAR_M = 0.05
NEAR_SHARE = 0.03  # of the range
MIN_CONTRAST = 8.0  # grey levels
MIN_VIEWS = 3
RANGES_M = (0, 1, 2, 3, 4, 5, 7, 100)
MATCH_PX = 0.5  # about what the depth maps' correlation has
SURFACE = numpy.dtype([("x", "<f4", 3), ("color", "u1", 3), ("contrast", "<f4"), ("views", "<u4"), ("sigma", "<f4"),
                       ("object", "<i4")])


@reads("a surface of rovio_sim --surface")
def read_surface(path):
    """The points of a true surface, and the names of the objects that they belong to."""
    header, _, body = open(path, "rb").read().partition(b"end_header\n")
    if b"property int object\n" not in header:
        raise Unreadable(f"{path}: no objects: expected a file of rovio_sim --surface")
    comments = [line.split() for line in header.decode().splitlines() if line.startswith("comment object ")]
    return numpy.frombuffer(body, SURFACE), {int(index): name for _, _, index, name in comments}


def on_objects(samples, names, prefix):
    """Which points of a surface belong to objects whose names begin with a prefix."""
    chosen = [index for index, name in names.items() if name.startswith(prefix)]
    if not chosen:
        raise Unreadable(f"--objects {prefix}: no object's name begins so; there are " + ", ".join(names.values()))
    return numpy.isin(samples["object"], chosen)


def shown_with_contrast(samples):
    """Which points of a surface enough keyframes see, and not as plain."""
    return (samples["contrast"] >= MIN_CONTRAST) & (samples["views"] >= MIN_VIEWS)


def expected_within(samples, reach_m):
    """The probability, point by point, that its place is found within a reach if every picture that sees it is off by
    MATCH_PX: what the drive allows."""
    return erf(reach_m / (MATCH_PX * samples["sigma"] * numpy.sqrt(2)))


@reads("a cloud or mesh (PLY)")
def read_points(path):
    """Of a cloud; of a mesh, points even over it."""
    open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)  # it warns on the standard output
    with open(path, "rb"):  # open3d takes a file that is not there for an empty one
        mesh = open3d.io.read_triangle_mesh(str(path))
    if len(mesh.triangles) == 0:
        points = numpy.asarray(open3d.io.read_point_cloud(str(path)).points)
        if len(points) == 0:
            raise Unreadable(f"{path}: no points: expected a cloud or mesh (PLY)")
        return points
    open3d.utility.random.seed(1)
    return numpy.asarray(mesh.sample_points_uniformly(max(100000, len(mesh.vertices))).points)


@reads("a trajectory: stamp, position and quaternion a line")
def read_centres(path):
    return {f"{row[0]:.6f}": row[1:4] for row in numpy.loadtxt(path, ndmin=2)}


def fit_similarity(estimate, truth):
    """Umeyama: scale, rotation, translation of truth from estimate."""
    a, b = estimate - estimate.mean(0), truth - truth.mean(0)
    u, values, v = numpy.linalg.svd(b.T @ a)
    signs = numpy.array([1, 1, numpy.sign(numpy.linalg.det(u @ v))])
    rotation = u @ numpy.diag(signs) @ v
    scale = (values * signs).sum() / (a**2).sum()
    return scale, rotation, truth.mean(0) - scale * rotation @ estimate.mean(0)


@reads("a calibration: fx fy cx cy, five of distortion, width and height")
def read_calibration(path):
    values = numpy.loadtxt(path)
    return values[0:2], values[2:4], values[9:11]


def ranges_of(points, ground_truth, stamps):
    """The distance to the nearest camera that has a point in its picture; to the nearest where none has."""
    focal, centre, size = read_calibration(pathlib.Path(ground_truth).parent / "calibration.txt")
    poses = [row for row in numpy.loadtxt(ground_truth, ndmin=2) if f"{row[0]:.6f}" in stamps]
    ranges = numpy.full(len(points), numpy.inf)
    for row in poses:
        seen = (points - row[1:4]) @ Rotation.from_quat(row[4:8]).as_matrix()
        with numpy.errstate(divide="ignore", invalid="ignore"):
            pixels = focal * seen[:, :2] / seen[:, 2:] + centre
        inside = (seen[:, 2] > 0) & (pixels >= 0).all(1) & (pixels < size).all(1)
        ranges[inside] = numpy.minimum(ranges[inside], numpy.linalg.norm(seen[inside], axis=1))
    to_any = cKDTree(numpy.array([row[1:4] for row in poses])).query(points)[0]
    return numpy.where(numpy.isfinite(ranges), ranges, to_any)


def measure_added(points, to_surface, ranges):
    return {"added": len(points), "added_3_percent": float((to_surface < NEAR_SHARE * ranges).mean())}


def measure_by_range(covered, ranges):
    figures = {}
    for near, far in zip(RANGES_M[:-1], RANGES_M[1:]):
        there = (ranges >= near) & (ranges < far)
        figures[f"share_{near}_to_{far}_m"] = float(there.mean())
        figures[f"completeness_{near}_to_{far}_m"] = float(covered[there].mean()) if there.any() else 0.0
    return figures


def measure(cloud, trajectory, ground_truth, surface, added_from=None, by_range=False,
            objects=None):
    estimate, truth = read_centres(trajectory), read_centres(ground_truth)
    stamps = sorted(set(estimate) & set(truth), key=float)
    if len(stamps) < 3:
        raise Unreadable(f"{trajectory}: {len(stamps)} poses have a stamp of {ground_truth}: expected three or more")
    scale, rotation, shift = fit_similarity(numpy.array([estimate[s] for s in stamps]),
                                            numpy.array([truth[s] for s in stamps]))
    points = scale * read_points(cloud) @ rotation.T + shift
    samples, names = read_surface(surface)
    to_surface = cKDTree(samples["x"]).query(points)[0]
    to_cloud = cKDTree(points).query(samples["x"])[0]
    wanted = shown_with_contrast(samples)
    figures = {
        "points": len(points),
        "accuracy_5cm": float((to_surface < NEAR_M).mean()),
        "accuracy_median_m": float(numpy.median(to_surface)),
        "farthest_m": float(to_surface.max()),
        "completeness_5cm": float((to_cloud[wanted] < NEAR_M).mean()),
        "completeness_5cm_whole": float((to_cloud < NEAR_M).mean()),
        "share_with_contrast": float(wanted.mean()),
    }
    if objects is not None:
        of_objects = wanted & on_objects(samples, names, objects)
        figures["completeness_5cm_objects"] = float((to_cloud[of_objects] < NEAR_M).mean())
    if added_from is not None:
        ranges = ranges_of(points[added_from:], ground_truth, set(stamps))
        figures.update(measure_added(points[added_from:], to_surface[added_from:], ranges))
    if by_range:
        ranges = ranges_of(samples["x"][wanted].astype(float), ground_truth, set(stamps))
        figures.update(measure_by_range(to_cloud[wanted] < NEAR_M, ranges))
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("cloud", "trajectory", "ground_truth", "surface"):
        parser.add_argument(name)
    parser.add_argument("--added-from", type=int, metavar="N")
    parser.add_argument("--by-range", action="store_true")
    parser.add_argument("--objects", metavar="PREFIX")
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    figures = measure(arguments.cloud, arguments.trajectory, arguments.ground_truth, arguments.surface,
                      arguments.added_from, arguments.by_range, arguments.objects)
    if arguments.json:
        print(json.dumps(figures))
        return 0
    for name, value in figures.items():
        print(f"{name:24} {value:.4g}")
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
