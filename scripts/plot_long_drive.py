#!/usr/bin/python3
"""Draws what a long drive costs, from the CSV that long_drive prints: plot_long_drive.py DRIVE.csv OUT.png"""

import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import end_plainly, reads  # noqa: E402  (after the path is set)

COLUMNS = ("keyframes", "resident_mib", "file_mib", "store_ms_per_keyframe")
FIRST = 500  # keyframes after which memory may grow by what the map itself takes alone


@reads("the table that long_drive prints")
def read_columns(path):
    with open(path) as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    return {name: [row[name] for row in rows] for name in COLUMNS} if rows else {}


def growth_kb(columns):
    """Resident kB a keyframe after the first ones: the slope of a line through all rows, as a single one may hold
    what an adjustment is about to give back; None: too short."""
    later = [(count, mib) for count, mib in zip(columns["keyframes"], columns["resident_mib"]) if count >= FIRST]
    if len(later) < 2:
        return None
    return 1024 * numpy.polyfit(*zip(*later), 1)[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("drive", "picture"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    columns = read_columns(arguments.drive)
    if not columns:
        print("plot_long_drive.py: no row", file=sys.stderr)
        return 1
    figure, (memory, time) = pyplot.subplots(2, 1, figsize=(7, 6), sharex=True, constrained_layout=True)
    memory.plot(columns["keyframes"], columns["resident_mib"], label="resident")
    memory.plot(columns["keyframes"], columns["file_mib"], label="on disk")
    memory.set_ylabel("MiB")
    memory.legend()
    growth = growth_kb(columns)
    if growth is not None:
        memory.set_title(f"{growth:.1f} kB a keyframe after the first {FIRST}", fontsize="medium")
    time.plot(columns["keyframes"], columns["store_ms_per_keyframe"])
    time.set_ylabel("CPU of the store, ms a keyframe")
    time.set_xlabel("keyframes")
    figure.savefig(arguments.picture, dpi=100)
    print(f"peak {max(columns['resident_mib']):.0f} MiB, growth {growth} kB a keyframe, store at most "
          f"{max(columns['store_ms_per_keyframe']):.1f} ms a keyframe")
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
