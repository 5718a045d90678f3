#!/usr/bin/python3
"""Draws a map from above and from the side: plot_map.py CLOUD.ply TRAJECTORY.txt OUT.png

The map's x axis points forward, z up, as map_images and export_map write it. Where the drives'
trajectories stand beside that of the map, each drive has its own line."""

import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import end_plainly, reads  # noqa: E402  (after the path is set)

VERTEX = numpy.dtype([("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("red", "u1"), ("green", "u1"),
                      ("blue", "u1"), ("session", "<u4"), ("views", "<u4"), ("error", "<f4")])
PATH_COLORS = ("red", "blue", "darkorange", "purple", "green", "brown")
PERCENTILES = (4, 96)  # of the cloud: what the picture frames beside the path


@reads("cloud.ply of a map")
def read_cloud(path):
    with open(path, "rb") as file:
        header, body = file.read().split(b"end_header\n", 1)
    unit = next((line.split("lengths in ")[1] for line in header.decode().splitlines()
                 if "lengths in " in line), "map units")
    return numpy.frombuffer(body, VERTEX), unit


@reads("a trajectory: stamp, position and quaternion a line")
def read_poses(path):
    return {line for line in open(path) if not line.startswith("#")}


@reads("a trajectory: stamp, position and quaternion a line")
def read_centers(path):
    return numpy.loadtxt(path, ndmin=2)[:, 1:4] if open(path).read().strip() else numpy.zeros((0, 3))


def read_paths(trajectory):
    """{drive: camera centres}; one without a name where the map has but one drive, or where the files of drives
    beside it are another map's: where they lack a pose of it."""
    files = sorted(pathlib.Path(trajectory).parent.glob("trajectory_*.txt"))
    if not files or read_poses(trajectory) - set.union(*map(read_poses, files)):
        return {"": read_centers(trajectory)}
    return {path.stem.split("_", 1)[1]: read_centers(path) for path in files}


def limits(path_axis, cloud_axis):
    values = [path_axis] + ([numpy.percentile(cloud_axis, PERCENTILES)] if len(cloud_axis) else [])
    low, high = numpy.concatenate(values).min(), numpy.concatenate(values).max()
    margin = 0.05 * (high - low) + 1e-6
    return low - margin, high + margin


def draw(axes, paths, points, colors, across, along, labels):
    axes.scatter(points[:, across], points[:, along], s=1.5, c=colors, linewidths=0)
    for i, (drive, path) in enumerate(paths.items()):
        color = PATH_COLORS[i % len(PATH_COLORS)]
        axes.plot(path[:, across], path[:, along], color=color, linewidth=1.2, label=drive)
        axes.plot(path[:1, across], path[:1, along], "o", color=color, markersize=4)
    whole = numpy.concatenate(list(paths.values()))
    axes.set_xlim(*limits(whole[:, across], points[:, across]))
    axes.set_ylim(*limits(whole[:, along], points[:, along]))
    axes.set_aspect("equal", adjustable="box")
    axes.set_facecolor("0.92")
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("cloud", "trajectory", "picture"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    cloud, unit = read_cloud(arguments.cloud)
    paths = read_paths(arguments.trajectory)
    num_cameras = sum(map(len, paths.values()))
    if num_cameras == 0:
        print("plot_map.py: the trajectory is empty", file=sys.stderr)
        return 1
    points = numpy.stack([cloud["x"], cloud["y"], cloud["z"]], 1)
    colors = numpy.stack([cloud["red"], cloud["green"], cloud["blue"]], 1) / 255.0
    figure, (above, side) = pyplot.subplots(1, 2, figsize=(14, 7), constrained_layout=True)
    draw(above, paths, points, colors, 0, 1, (f"x, forward [{unit}]", f"y, left [{unit}]"))
    above.set_title(f"from above: {len(cloud)} points, {num_cameras} cameras")
    if len(paths) > 1:
        above.legend()
    draw(side, paths, points, colors, 0, 2, (f"x, forward [{unit}]", f"z, up [{unit}]"))
    side.set_title("from the side")
    figure.savefig(arguments.picture, dpi=100)
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
