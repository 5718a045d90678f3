#!/usr/bin/python3
"""Draws two drives, apart and merged, and the merged paths beside the true ones (Figures 5.23 to 5.25
of the thesis), and prints the figures of Tables 5.8 and 5.9:

plot_merge.py FIRST_MAP SECOND_MAP MERGED_MAP FIRST_DRIVE SECOND_DRIVE OUT

The maps are results of map_images: of either drive alone, and of both; the drives their data sets.
Writes separate.png, merged.png and truth.png into OUT."""

import argparse
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from acceptance.trajectories import drive_paths, read_centers, transform, umeyama  # noqa: E402
from plot_map import limits, read_cloud  # noqa: E402
from read_plainly import end_plainly, reads  # noqa: E402

COLORS = ("tab:green", "tab:red")


def draw_map(axes, folder, paths, title):
    """A map from above: its cloud, grey, and its camera paths, drive by drive."""
    cloud, unit = read_cloud(folder / "cloud.ply")
    every = numpy.concatenate(paths)
    axes.scatter(cloud["x"], cloud["y"], s=0.8, c="0.55", linewidths=0)
    for path, color in zip(paths, COLORS):
        axes.plot(path[:, 0], path[:, 1], ".-", color=color, markersize=4, linewidth=1)
    axes.set_xlim(*limits(every[:, 0], cloud["x"]))
    axes.set_ylim(*limits(every[:, 1], cloud["y"]))
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlabel(f"x [{unit}]")
    axes.set_ylabel(f"y [{unit}]")
    axes.set_title(title)


def centers(path):
    found = read_centers(path)
    return numpy.array([found[stamp] for stamp in sorted(found)])


def draw_separate(maps, names, out):
    figure, both = pyplot.subplots(1, 2, figsize=(14, 7), constrained_layout=True)
    for axes, folder, name in zip(both, maps, names):
        draw_map(axes, folder, [centers(folder / "trajectory.txt")], name)
    figure.savefig(out / "separate.png", dpi=100)


def draw_merged(folder, out):
    figure, axes = pyplot.subplots(figsize=(11, 8), constrained_layout=True)
    paths = [centers(folder / f"trajectory_folder_{i}.txt") for i in range(2)]
    draw_map(axes, folder, paths, "merged")
    figure.savefig(out / "merged.png", dpi=100)


def draw_truth(folder, drives, out):
    """The merged paths, aligned with the truth by one similarity. Returns the errors, mm."""
    paths = drive_paths(folder, drives)
    similarity = umeyama(*(numpy.concatenate(part) for part in zip(*paths)))
    figure, axes = pyplot.subplots(figsize=(10, 6), constrained_layout=True)
    errors_mm = []
    for (estimate, truth), color, name in zip(paths, COLORS, ("first drive", "second drive")):
        aligned = transform(similarity, estimate)
        errors_mm.append(1000 * numpy.linalg.norm(aligned - truth, axis=1))
        axes.plot(truth[:, 0], truth[:, 1], "+", color="black", markersize=7)
        axes.plot(aligned[:, 0], aligned[:, 1], "o", color=color, markersize=3, label=name)
    axes.plot([], [], "+", color="black", label="truth")
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.legend()
    figure.savefig(out / "truth.png", dpi=100)
    return errors_mm


@reads("summary.json of a map")
def read_summary(path):
    return json.loads(path.read_text())


def print_tables(maps, names, errors_mm):
    summaries = [read_summary(folder / "summary.json") for folder in maps]
    print("| map | projections | landmarks | RMS_N | RMS px |\n|---|---|---|---|---|")
    for name, s in zip(names, summaries):
        points = s["landmarks"] + s["landmarks_two_views"]
        print(f"| {name} | {s['projections']} | {points} | {s['rms_n']:.2f} | {s['rms_px']:.2f} |")
    print()
    for report in summaries[-1]["merges"]["reports"]:
        if report["verdict"] == "accepted" and report["kind"] != "loop":
            print(f"merged by {report['query']} against {report['other']}: {report['matches']} matches, "
                  f"{report['common_landmarks']} common landmarks, {report['links']} links")
    for name, errors in zip(names, errors_mm):
        print(f"{name}: camera centres off by {numpy.sqrt((errors**2).mean()):.2f} mm RMS, {errors.max():.2f} "
              f"mm at most")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("first", "second", "merged", "first_drive", "second_drive", "out"):
        parser.add_argument(name, type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    maps = arguments.first, arguments.second, arguments.merged
    names = "first drive", "second drive", "merged"
    draw_separate(maps[:2], names, arguments.out)
    draw_merged(arguments.merged, arguments.out)
    errors_mm = draw_truth(arguments.merged, (arguments.first_drive, arguments.second_drive), arguments.out)
    print_tables(maps, names, errors_mm)
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
