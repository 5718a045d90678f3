#!/usr/bin/python3
"""Draws what joining drives one by one costs, from what many_merges prints:
plot_many_merges.py MERGES.csv OUT.png"""

import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from read_plainly import end_plainly, reads  # noqa: E402  (after the path is set)


@reads("what many_merges prints")
def read_columns(path):
    """The numbers of the table by column; other lines are sentences."""
    with open(path) as file:
        table = [line for line in file if line.startswith("merge,") or line[:1].isdigit()]
    rows = list(csv.DictReader(table))
    return {name: [float(row[name]) for row in rows] for name in rows[0] if name != "verdict"} if rows else {}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    for name in ("merges", "picture"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    columns = read_columns(arguments.merges)
    if not columns:
        print("plot_many_merges.py: no row", file=sys.stderr)
        return 1
    merges, unmerged_mib = columns["merge"], columns["unmerged_kb"][0] / 1024
    touched, total = [], 0.0
    for keyframes in columns["keyframes"]:
        total += keyframes
        touched.append(total)
    figure, (memory, time) = pyplot.subplots(2, 1, figsize=(7, 6), sharex=True, constrained_layout=True)
    memory.plot(merges, [kb / 1024 for kb in columns["added_kb"]], label="added by the merges")
    memory.axhline(0.3 * unmerged_mib, color="gray", linestyle=":", label="30 % of the drives unmerged")
    memory.set_ylabel("MiB")
    memory.legend()
    each_kb = columns["added_kb"][-1] / touched[-1]
    share = columns["added_kb"][-1] / columns["unmerged_kb"][0]
    memory.set_title(f"{each_kb:.2f} kB a keyframe and merge, {100 * share:.1f} % of the drives unmerged "
                     f"({unmerged_mib:.0f} MiB)", fontsize="medium")
    time.plot(merges, columns["merge_ms"], label="merge")
    time.plot(merges, columns["adjust_ms"], label="copy for the adjustment, and its result")
    time.set_ylabel("CPU of the mapper's thread, ms")
    time.set_ylim(bottom=0)
    time.set_xlabel("merge")
    time.legend()
    figure.savefig(arguments.picture, dpi=100)
    print(f"{each_kb:.2f} kB a keyframe and merge, {100 * share:.1f} %; merge {merges[-1]:.0f}: "
          f"{columns['merge_ms'][-1]:.0f} ms, merge 3: {columns['merge_ms'][min(2, len(merges) - 1)]:.0f} ms")
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
