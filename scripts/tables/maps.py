"""Tables 3.7 and 5.1 to 5.6: what is in the maps, and in COLMAP's of the same pictures."""

import json

from acceptance.common import ROOT
from comparison.images import read_set
from tables import scope as settings
from tables.page import markdown
from tables.runs import KEPT, error_percent, points

COLMAP = ROOT / "docs/colmap.json"
VARIANTS = ("COLMAP hurried", "COLMAP")
MAP_HEAD = ("registered", "points", "projections", "RMS, px", "error, % of the path", "rotation, °", "CPU, s")
THESIS_ERRORS = (("thesis, before post-process", "1.02", "0.62", "0.98", "0.79"),
                 ("thesis, after it", "1.64", "1.34", "1.62", "1.57"),
                 ("thesis, VisualSFM", "3.75", "0.77", "1.14", "1.36"),
                 ("thesis, AgiSoft", "1.32", "1.16", "1.60", "1.53"))
TOURS = ("visionlab", "turntable", "industrialArea", "pipeline")


def colmap(pictures):
    """COLMAP's figures of these pictures, by variant; those that were not made are missing."""
    images = read_set(pictures, 1, KEPT / "sets")
    kept = json.loads(COLMAP.read_text())
    keys = {variant: f"{images.name} {variant} {images.fingerprint}" for variant in VARIANTS}
    return {variant: kept[key] for variant, key in keys.items() if key in kept}


def densified(scope, tour):
    return scope.map(tour, settings.DENSIFIED).summary["densified"]


def trimming(scope):
    """Table 3.7."""
    s, d = scope.map("visionlab").summary, densified(scope, "visionlab")
    rows = [("thesis, SfM", "15.5 %", 3563, 11982, 40623), ("thesis, post-process", "33.1 %", 15558, 24393, 100777),
            ("ours", f"{100 * s['tracks']['f1_share']:.1f} %", f"{s['tracks']['observations_deleted']} observations",
             points(s), s["projections"]),
            ("ours, densified", f"{100 * d['refused_f1'] / max(1, d['matches']):.1f} %", d["removed_by_reprojection"],
             d["landmarks"], d["projections"])]
    return markdown(("", "matches refused by f1", "deleted by reprojection", "points", "projections"), rows)


def track_lengths(scope):
    """Table 5.1."""
    rows = [("thesis, visionlab", "82.1 %", "17.9 %", 3.53), ("thesis, turntable", "95.0 %", "5.1 %", None)]
    for tour in ("visionlab", "turntable"):
        s = scope.map(tour).summary
        lengths = {int(length): count for length, count in s["tracks"]["length_histogram"].items()}
        views = sum(length * count for length, count in lengths.items())
        short = sum(length * count for length, count in lengths.items() if length <= 4)
        rows.append((f"ours, {tour}", f"{100 * short / views:.1f} %", f"{100 * (1 - short / views):.1f} %",
                     s["projections"] / points(s)))
    return markdown(("projections in tracks of", "2 to 4 views", "more than 4", "views of a point"), rows)


def systems(tour, thesis):
    """A table like 5.2 with 5.3, or 5.4 with 5.5."""
    def table(scope):
        rows = list(thesis)
        s, d = scope.map(tour).summary, densified(scope, tour)
        rows.append(("ours", s["rms_n"], s["projections"], points(s), *ratios(s["projections"], points(s), s["registered"])))
        rows.append(("ours, densified", d["rms_n"], d["projections"], d["landmarks"],
                     *ratios(d["projections"], d["landmarks"], s["registered"])))
        found = colmap(scope.pictures(tour))
        for variant in VARIANTS:
            r = found.get(variant)
            rows.append((variant, r["rms_n"], r["projections"], r["landmarks"],
                         *ratios(r["projections"], r["landmarks"], r["registered"])) if r else (variant, *[None] * 5))
        return markdown(("system", "RMS_N", "projections", "points", "projections a point", "projections a camera"), rows)
    return table


def ratios(projections, num_points, cameras):
    return projections / max(1, num_points), f"{projections / max(1, cameras):.0f}"


def reprojection(scope):
    """Table 5.6: RMS_N."""
    ours, dense, theirs = ["ours"], ["ours, densified"], {variant: [variant] for variant in VARIANTS}
    for tour in TOURS:
        ours.append(scope.map(tour).summary["rms_n"])
        dense.append(densified(scope, tour)["rms_n"])
        found = colmap(scope.pictures(tour))
        for variant, row in theirs.items():
            row.append(found[variant]["rms_n"] if variant in found else None)
    return markdown(("system", *TOURS), [*THESIS_ERRORS, ours, dense, *theirs.values()])


def map_row(name, run):
    s = run.summary
    return (name, f"{s['registered']} of {s['frames']}" + (f" in {s['maps']} maps" if s["maps"] > 1 else ""), points(s),
            s["projections"], s["rms_px"], share(s), s["rotation_rmse_deg"], f"{run.cost.cpu_s:.0f}")


def share(summary):
    value = error_percent(summary)
    return None if value is None else f"{value:.3f}"


def gate(scope):
    """§3.5, the odometry gate."""
    rows = [map_row(f"{tour}, gate {'on' if on else 'off'}", scope.map(tour, settings.odometry_gate(on)))
            for tour in ("visionlab", "turntable") for on in (False, True)]
    return markdown(("tour", *MAP_HEAD), rows)


def choices(scope):
    """A map of visionlab with each of the methods that can be chosen."""
    chosen = [*((f"features: {name}", settings.feature(name)) for name in settings.FEATURES),
              *((f"matcher: {name}", settings.matcher(name)) for name in settings.MATCHERS),
              *((f"pose of a pair: {name}", settings.pose_method(name)) for name in ("five_point", "algebraic"))]
    return markdown(("map with", *MAP_HEAD), [map_row(name, scope.map("visionlab", setting)) for name, setting in chosen])
