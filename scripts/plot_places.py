#!/usr/bin/python3
"""Draws precision over recall of evaluate_places: plot_places.py CURVES.csv OUT.png"""

import argparse
import collections
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import end_plainly, reads  # noqa: E402  (after the path is set)

LABELS = {"fabmap": "FAB-MAP", "fabmap_verified": "FAB-MAP and geometry", "tf_idf": "tf-idf"}


@reads("curves.csv of evaluate_places")
def read_curves(path):
    curves = collections.OrderedDict()
    with open(path) as file:
        for row in csv.DictReader(file):
            point = float(row["recall"]), float(row["precision"])
            curves.setdefault(row["method"], []).append(point)
    return curves


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("curves", "picture"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    curves = read_curves(arguments.curves)
    if not curves:
        print("plot_places.py: no curve has a point", file=sys.stderr)
        return 1
    figure, axes = pyplot.subplots(figsize=(7, 5), constrained_layout=True)
    for method, points in curves.items():
        recalls, precisions = zip(*points)
        axes.plot(recalls, precisions, marker=".", markersize=3, label=LABELS.get(method, method))
    axes.set_xlabel("recall")
    axes.set_ylabel("precision")
    axes.set_xlim(0, 1.02)
    axes.set_ylim(0, 1.02)
    axes.grid(color="0.85")
    axes.legend(loc="lower left")
    figure.savefig(arguments.picture, dpi=100)
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
