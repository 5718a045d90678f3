#!/usr/bin/python3
"""Plots the cost of a place query against the number of places, postings and the rest apart.

plot_places_scale.py FIGURES.json OUT.png

FIGURES.json: benchmarks --benchmark_filter='QueryPlaces|WalkPostings|PassOverPlaces'
--benchmark_out=FIGURES.json --benchmark_out_format=json"""

import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import end_plainly, reads, take_words  # noqa: E402  (after the path is set)

LABELS = {
    "QueryPlaces": "whole query",
    "WalkPostings": "postings",
    "PassOverPlaces": "pass over the places",
}


@reads("figures of the benchmarks as JSON")
def read_curves(path):
    """Per benchmark the sorted pairs (places, milliseconds)."""
    curves = {name: [] for name in LABELS}
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            name, _, size = run["name"].partition("/")
            if name in curves and run.get("run_type", "iteration") == "iteration":
                curves[name].append((int(size), run["cpu_time"]))
    return {name: sorted(curve) for name, curve in curves.items()}


def plot(curves, path):
    figure, axes = plt.subplots(figsize=(7, 4.5))
    for name, label in LABELS.items():
        if curves[name]:
            axes.loglog(*zip(*curves[name]), marker="o", label=label)
    axes.loglog([1000, 10_000, 100_000], [20, 22, 40], "k_", markersize=14, label="limit")
    axes.set_xlabel("places")
    axes.set_ylabel("ms a query")
    axes.grid(True, which="both", alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, dpi=120)


def main():
    words = take_words(__doc__, most=2)
    if len(words) < 2:
        sys.exit("plot_places_scale.py: expected FIGURES.json and OUT.png; --help tells more")
    plot(read_curves(words[0]), words[1])
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
