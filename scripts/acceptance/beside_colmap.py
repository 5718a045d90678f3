"""The lines beside COLMAP, whose kept figures stand in docs/colmap.json."""

import functools
import json

from acceptance.common import ROOT, WORK, Line, dataset, run
from acceptance.renders import Render, render
from acceptance.stage_1 import TOURS
from comparison.table import AS_MANY

STRIDES = {"tum_fr1_xyz": 4, "hololens_dvmvs_000": 2}
MAX_WORSE, MAX_ERROR_RATIO = 1, 1.3  # sets on which COLMAP may be more accurate, and by how much
MIN_COUNTS = 1.1  # times COLMAP's landmarks, and projections of a picture
MIN_TIMES, MIN_TIMES_HURRIED = 20, 5  # faster than COLMAP, by CPU time


def compared(folders, *options):
    """Entries of compare.json."""
    out = WORK / "compare"
    run(ROOT / "scripts/compare", *folders, "--runs", 1, "--out", out, *options)
    return json.loads((out / "compare.json").read_text())


def fountain(_quick):
    entry = compared([dataset("strecha_fountain_p11")])[0]
    holds, parts = True, []
    for title, theirs in entry["colmap"].items():
        ours = entry["ours"][theirs["compare_with"][0]]
        holds = (holds and ours["registered"] >= theirs["registered"] and ours["error_m"] <= theirs["error_m"]
                 and ours["landmarks"] >= theirs["landmarks"] and ours["projections"] >= theirs["projections"])
        parts.append(f"{title}: {100 * ours['error_m']:.2f} against {100 * theirs['error_m']:.2f} cm, landmarks "
                     f"{ours['landmarks'] / theirs['landmarks']:.2f} x, projections "
                     f"{ours['projections'] / theirs['projections']:.2f} x, CPU {ours['cost']['cpu_s']:.0f} against "
                     f"{theirs['cost']['cpu_s']:.0f} s")
    return holds, "; ".join(parts)


@functools.cache
def beside_hurried():
    """Entries of every set with a truth: the tours by the robot's camera and two real ones."""
    entries = compared([render(Render(name)) for name in TOURS], "--hurried-only")
    for name, stride in STRIDES.items():
        entries += compared([dataset(name)], "--hurried-only", "--stride", stride)
    return entries


def pairs(of_ours="ours"):
    """Name, ours and COLMAP hurried of each."""
    return [(entry["name"], entry["ours"].get(of_ours, entry["ours"]["ours"]), entry["colmap"]["COLMAP hurried"])
            for entry in beside_hurried()]


def errors(_quick):
    ratios = {name: ours["error_m"] / theirs["error_m"] for name, ours, theirs in pairs()}
    fewer = [name for name, ours, theirs in pairs() if ours["registered"] < theirs["registered"]]
    worse = [name for name, ratio in ratios.items() if ratio > 1]
    holds = not fewer and len(worse) <= MAX_WORSE and max(ratios.values()) <= MAX_ERROR_RATIO
    told = ", ".join(f"{name} {ratio:.2f}" for name, ratio in ratios.items())
    return holds, f"error, times COLMAP's: {told}; fewer pictures: {', '.join(fewer) or 'none'}"


def count_ratios(of_ours):
    """Of landmarks and projections, by set; but where COLMAP has a part of the pictures: its counts of that say nothing."""
    return {name: [ours[key] / theirs[key] for key in ("landmarks", "projections")]
            for name, ours, theirs in pairs(of_ours) if theirs["registered"] >= ours["registered"]}


def counts(_quick):
    """Told 1000 features COLMAP takes 1213 to 1459 of the tours' pictures: ours may have as many."""
    of_as_many, of_1000 = count_ratios(AS_MANY), count_ratios("ours")
    parts = [f"{name} {a:.2f} and {b:.2f} (of 1000 {of_1000[name][0]:.2f} and {of_1000[name][1]:.2f})"
             for name, (a, b) in of_as_many.items()]
    holds = bool(parts) and all(min(ratios) >= MIN_COUNTS for ratios in of_as_many.values())
    return holds, f"landmarks and projections, times COLMAP's: {', '.join(parts)}"


def times_faster():
    """Than COLMAP hurried and than COLMAP as it comes, whose figures are kept, by set."""
    kept = json.loads((ROOT / "docs/colmap.json").read_text())
    as_it_comes = {key.rsplit(" ", 2)[0]: figures for key, figures in kept.items() if key.split(" ")[1:-1] == ["COLMAP"]}
    return {name: [theirs["cost"]["cpu_s"] / ours["cost"]["cpu_s"],
                   as_it_comes[name]["cost"]["cpu_s"] / ours["cost"]["cpu_s"]] for name, ours, theirs in pairs()}


def cpu(_quick):
    """Judged on the tours. On fr1 COLMAP finds few features, and of hololens it maps two fifths of the pictures or an eighth."""
    times = times_faster()
    tours = [ratios for name, ratios in times.items() if not name.startswith(tuple(STRIDES))]
    holds = bool(tours) and all(hurried >= MIN_TIMES_HURRIED and as_it_comes >= MIN_TIMES for hurried, as_it_comes in tours)
    told = ", ".join(f"{name} {hurried:.1f} and {as_it_comes:.1f}" for name, (hurried, as_it_comes) in times.items())
    return holds, f"CPU time, times less than COLMAP hurried's and COLMAP's: {told}"


LINES = [
    Line("compare", "fountain beside COLMAP: as many pictures, no larger error, no fewer landmarks and projections", fountain,
         False),
    Line("compare_errors", f"tours, fr1 every 4th, hololens every 2nd beside COLMAP hurried: as many pictures; error larger on "
         f"at most {MAX_WORSE}, by <= {MAX_ERROR_RATIO} x", errors, False),
    Line("compare_counts", f"tours and fr1 every 4th beside COLMAP hurried: >= {MIN_COUNTS} x the landmarks and projections, "
         "of as many features",
         counts, False),
    Line("compare_cpu", f"CPU time on the tours: <= 1/{MIN_TIMES} of COLMAP's, <= 1/{MIN_TIMES_HURRIED} of COLMAP hurried's; fr1 "
         "every 4th and hololens every 2nd told", cpu, False),
]
