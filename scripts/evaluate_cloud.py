#!/usr/bin/python3
"""Compares a dense cloud or a mesh of a rendered tour with the true surface, after one similarity of
the trajectories:
  evaluate_cloud.py CLOUD.ply TRAJECTORY.txt GROUNDTRUTH.txt SURFACE.ply [--json]
CLOUD: dense.ply, densified.ply or mesh.ply (its corners and points even over its triangles);
SURFACE: of rovio_sim --surface. Prints shares within 5 cm and medians in metres."""

import argparse
import json

import numpy
import open3d
from scipy.spatial import cKDTree

NEAR_M = 0.05
MIN_CONTRAST = 8.0  # grey levels
MIN_VIEWS = 3
SURFACE = numpy.dtype([("x", "<f4", 3), ("color", "u1", 3), ("contrast", "<f4"), ("views", "<u4")])


def read_surface(path):
    header, _, body = open(path, "rb").read().partition(b"end_header\n")
    if b"property float contrast\n" not in header:
        raise SystemExit(f"{path}: no contrast: expected a file of rovio_sim --surface")
    return numpy.frombuffer(body, SURFACE)


def read_points(path):
    """Of a cloud; of a mesh, points even over it."""
    mesh = open3d.io.read_triangle_mesh(str(path))
    if len(mesh.triangles) == 0:
        return numpy.asarray(open3d.io.read_point_cloud(str(path)).points)
    open3d.utility.random.seed(1)
    return numpy.asarray(mesh.sample_points_uniformly(max(100000, len(mesh.vertices))).points)


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


def measure(cloud, trajectory, ground_truth, surface):
    estimate, truth = read_centres(trajectory), read_centres(ground_truth)
    stamps = sorted(set(estimate) & set(truth), key=float)
    scale, rotation, shift = fit_similarity(numpy.array([estimate[s] for s in stamps]),
                                            numpy.array([truth[s] for s in stamps]))
    points = scale * read_points(cloud) @ rotation.T + shift
    samples = read_surface(surface)
    to_surface = cKDTree(samples["x"]).query(points)[0]
    to_cloud = cKDTree(points).query(samples["x"])[0]
    wanted = (samples["contrast"] >= MIN_CONTRAST) & (samples["views"] >= MIN_VIEWS)
    return {
        "points": len(points),
        "accuracy_5cm": float((to_surface < NEAR_M).mean()),
        "accuracy_median_m": float(numpy.median(to_surface)),
        "completeness_5cm": float((to_cloud[wanted] < NEAR_M).mean()),
        "completeness_5cm_whole": float((to_cloud < NEAR_M).mean()),
        "share_with_contrast": float(wanted.mean()),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("cloud", "trajectory", "ground_truth", "surface"):
        parser.add_argument(name)
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    figures = measure(arguments.cloud, arguments.trajectory, arguments.ground_truth, arguments.surface)
    if arguments.json:
        print(json.dumps(figures))
        return
    for name, value in figures.items():
        print(f"{name:24} {value:.4g}")


if __name__ == "__main__":
    main()
