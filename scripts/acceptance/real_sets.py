"""The lines about real pictures that are hard: fast, blurred, weak, turning."""

import json
import re
import subprocess

from acceptance.common import ROOT, WORK, Line, dataset, fresh_folder, map_images, percent
from stamp_delay import best_delay, errors_by_delay

MAX_KEYFRAME_ERROR_M = 0.0097
PERIOD_MS = 33  # of the camera; a shutter that rolls from the stamp on is late by half of it


def figures(summary):
    error = summary["ate_rmse_m"]
    return (f"{summary['registered']} of {summary['frames']} in the largest of {summary['maps']} maps, "
            + ("no error known" if error is None else f"{100 * error:.2f} cm") + f", {summary['wall_s']:.0f} s")


def real_set(name, folder, min_share, max_error_m, *options):
    """min_share: per cent of the pictures in one map."""
    def check(_quick):
        s = map_images(f"real/{name}", [dataset(folder)], *options)
        holds = percent(s["registered"], s["frames"]) >= min_share
        return holds and (s["ate_rmse_m"] or float("inf")) <= max_error_m, figures(s)
    return check


def keyframes_of_fr1(quick):
    """Keyframes are where the camera is fast: there pictures that are stamped early show as error."""
    s = map_images("real/fr1_xyz", [dataset("tum_fr1_xyz")], "--mode", "parallax", *(("--stride", 8) if quick else ()))
    error, keyframe_error = s["ate_rmse_m"] or float("inf"), s["ate_rmse_keyframes_m"] or float("inf")
    said = f"{figures(s)}; keyframes {100 * keyframe_error:.2f} cm"
    if quick:
        return (percent(s["registered"], s["frames"]) >= 98 and error <= 0.05), said + " (every 8th, >= 98 %, <= 5 cm)"
    errors = errors_by_delay(WORK / "real/fr1_xyz", dataset("tum_fr1_xyz") / "groundtruth.txt")
    delay_ms = best_delay(errors)
    said += f", {100 * errors[delay_ms][1]:.2f} cm with all stamps {delay_ms} ms later"
    explained = 0 < delay_ms < PERIOD_MS and errors[delay_ms][1] <= MAX_KEYFRAME_ERROR_M
    is_small = keyframe_error <= MAX_KEYFRAME_ERROR_M or explained
    return s["registered"] == s["frames"] and error <= 0.010 and is_small, said


def cabinet(_quick):
    """A plain box on a plain floor: a map, or what is missing in figures."""
    folder = fresh_folder("real/cabinet")
    done = subprocess.run([ROOT / "scripts/map_images", dataset("tum_fr3_cabinet58"), "--out", folder], capture_output=True,
                          text=True, check=False)
    summary = json.loads((folder / "summary.json").read_text())
    why = re.search(r"(no image was registered|images? ha(?:ve|s) no pose): .* shows \d+ features and shares \d+ points .* share \d+ .*",
                    done.stdout)
    explained = why is not None and done.returncode == (0 if summary["registered"] else 2)
    mapped = done.returncode == 0 and summary["registered"] >= 50 and (summary["ate_rmse_m"] or float("inf")) <= 0.1
    return mapped or explained, figures(summary) + (f"; {why.group()}" if why else "")


LINES = [
    Line("fr1_xyz", "tum_fr1_xyz, parallax: all pictures, <= 1.0 cm, keyframes <= 0.97 cm, or with one delay of all stamps",
         keyframes_of_fr1, True),
    Line("fr1_rpy", "tum_fr1_rpy alone: >= 96 % in one map, <= 2.6 cm",
         real_set("fr1_rpy", "tum_fr1_rpy", 96, 0.026, "--mode", "parallax"), False),
    Line("hololens", "hololens_dvmvs_000: >= 98 % in one map, <= 6 cm",
         real_set("hololens", "hololens_dvmvs_000", 98, 0.06), False),
    Line("hololens_half", "hololens_dvmvs_000, every 2nd: >= 90 % in one map, <= 8 cm",
         real_set("hololens_half", "hololens_dvmvs_000", 90, 0.08, "--stride", 2), False),
    Line("cabinet", "tum_fr3_cabinet58: >= 50 of 58, <= 10 cm, or a sentence that says in figures what is missing", cabinet, False),
]
