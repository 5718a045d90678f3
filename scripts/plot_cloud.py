#!/usr/bin/python3
"""Draws a cloud or mesh (PLY) from above and from the side: plot_cloud.py FILE.ply OUT.png"""

import argparse
import pathlib
import sys

import matplotlib
import numpy
import open3d

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 (after the choice of its backend)

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import Unreadable, end_plainly, reads  # noqa: E402  (after the path is set)

MAX_POINTS = 400000


@reads("a cloud or mesh (PLY)")
def read(path):
    with open(path, "rb"):  # open3d takes a file that is not there for an empty one
        mesh = open3d.io.read_triangle_mesh(path)
    if len(mesh.triangles) > 0:
        mesh.compute_vertex_normals()
        cloud = mesh.sample_points_uniformly(MAX_POINTS)
    else:
        cloud = open3d.io.read_point_cloud(path)
    points, colors = numpy.asarray(cloud.points), numpy.asarray(cloud.colors)
    if len(points) == 0:
        raise Unreadable(f"{path}: no points: expected a cloud or mesh (PLY)")
    low, high = numpy.quantile(points, [0.005, 0.995], axis=0)
    inside = ((points >= low) & (points <= high)).all(1)
    return points[inside], colors[inside]


def draw(axes, points, colors, horizontal, vertical, depth, sign):
    order = numpy.argsort(sign * points[:, depth])
    axes.scatter(points[order, horizontal], points[order, vertical], c=colors[order], s=0.3, linewidths=0)
    axes.set_aspect("equal")


def draw_oblique(axes, points, colors):
    turn, tilt = numpy.radians(35), numpy.radians(35)
    x = points[:, 0] * numpy.cos(turn) - points[:, 1] * numpy.sin(turn)
    y = points[:, 0] * numpy.sin(turn) + points[:, 1] * numpy.cos(turn)
    up = y * numpy.sin(tilt) + points[:, 2] * numpy.cos(tilt)
    away = y * numpy.cos(tilt) - points[:, 2] * numpy.sin(tilt)
    order = numpy.argsort(-away)
    axes.scatter(x[order], up[order], c=colors[order], s=0.3, linewidths=0)
    axes.set_aspect("equal")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("cloud", "picture"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    points, colors = read(arguments.cloud)
    figure, axes = pyplot.subplots(1, 3, figsize=(21, 7))
    draw(axes[0], points, colors, 0, 1, 2, 1)
    axes[0].set_title("from above")
    draw(axes[1], points, colors, 0, 2, 1, -1)
    axes[1].set_title("from the side")
    draw_oblique(axes[2], points, colors)
    axes[2].set_title("oblique")
    figure.tight_layout()
    figure.savefig(arguments.picture, dpi=80)
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
