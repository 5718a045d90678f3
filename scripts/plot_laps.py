#!/usr/bin/python3
"""Draws two laps of one drive over each other, as Fig. 5.27 of the thesis, and prints how far each
camera of the second lap lies from where it truly was beside its neighbour of the first:

plot_laps.py TRAJECTORY.txt GROUNDTRUTH.txt PICTURES_OF_THE_FIRST_LAP OUT.png"""

import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from acceptance.trajectories import pair_up, read_centers, transform, umeyama  # noqa: E402
from read_plainly import Unreadable, end_plainly  # noqa: E402


def neighbours(truth, first_lap):
    """(picture of the first lap, picture of the second) on one spot, or near it."""
    laps = truth[:first_lap], truth[first_lap:]
    return [(int(numpy.linalg.norm(laps[0] - center, axis=1).argmin()), first_lap + i)
            for i, center in enumerate(laps[1])]


def draw(axes, estimate, truth, first_lap):
    axes.plot(truth[:, 0], truth[:, 1], "+", color="0.6", markersize=7, label="truth")
    axes.plot(*estimate[:first_lap, :2].T, "o", color="green", markersize=4, label="first lap")
    axes.plot(*estimate[first_lap:, :2].T, "o", color="red", markersize=2.5, label="second lap")
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.legend(loc="center")


def draw_gaps(axes, true_m, estimated_m):
    axes.plot(1000 * true_m, color="0.5", label="true")
    axes.plot(1000 * estimated_m, color="red", linewidth=1, label="estimated")
    axes.set_xlabel("camera of the second lap")
    axes.set_ylabel("distance from its neighbour in the first lap [mm]")
    axes.legend()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("trajectory", type=pathlib.Path)
    parser.add_argument("truth", type=pathlib.Path)
    parser.add_argument("first_lap", type=int)
    parser.add_argument("picture", type=pathlib.Path)
    arguments = parser.parse_args()
    truth_of = read_centers(arguments.truth)
    centers = read_centers(arguments.trajectory)
    if not centers or not 0 < arguments.first_lap < len(truth_of):
        raise Unreadable(f"{arguments.truth}: {len(truth_of)} pictures, {arguments.first_lap} of the first lap, and "
                         f"{len(centers)} poses in {arguments.trajectory}: expected two laps")
    estimate, truth = pair_up(centers, truth_of)
    last_stamp = sorted(truth_of)[arguments.first_lap - 1]
    first_lap = sum(stamp <= last_stamp for stamp in centers)
    estimate = transform(umeyama(estimate, truth), estimate)
    pairs = neighbours(truth, first_lap)
    offset = numpy.array([estimate[b] - estimate[a] for a, b in pairs])
    true_offset = numpy.array([truth[b] - truth[a] for a, b in pairs])
    error_mm = 1000 * numpy.linalg.norm(offset - true_offset, axis=1)
    figure, (path, gaps) = pyplot.subplots(1, 2, figsize=(13, 6), constrained_layout=True)
    draw(path, estimate, truth, first_lap)
    draw_gaps(gaps, numpy.linalg.norm(true_offset, axis=1), numpy.linalg.norm(offset, axis=1))
    figure.savefig(arguments.picture, dpi=110)
    print(f"laps apart by their true offsets within: median {numpy.median(error_mm):.2f} mm, "
          f"largest {error_mm.max():.2f} mm, {len(pairs)} pairs")
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
