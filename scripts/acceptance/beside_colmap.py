"""The line beside COLMAP, whose kept figures stand in docs/colmap.json."""

import json

from acceptance.common import ROOT, WORK, Line, dataset, run


def fountain(_quick):
    out = WORK / "compare"
    run(ROOT / "scripts/compare", dataset("strecha_fountain_p11"), "--runs", 1, "--out", out)
    entry = json.loads((out / "compare.json").read_text())[0]
    holds, parts = True, []
    for title, theirs in entry["colmap"].items():
        ours = entry["ours"][theirs["compare_with"]]
        holds = (holds and ours["registered"] >= theirs["registered"] and ours["error_m"] <= theirs["error_m"]
                 and ours["landmarks"] >= theirs["landmarks"] and ours["projections"] >= theirs["projections"])
        parts.append(f"{title}: {100 * ours['error_m']:.2f} against {100 * theirs['error_m']:.2f} cm, landmarks "
                     f"{ours['landmarks'] / theirs['landmarks']:.2f} x, projections "
                     f"{ours['projections'] / theirs['projections']:.2f} x, CPU {ours['cost']['cpu_s']:.0f} against "
                     f"{theirs['cost']['cpu_s']:.0f} s")
    return holds, "; ".join(parts)


LINES = [
    Line("compare", "fountain beside COLMAP: as many pictures, no larger error, no fewer landmarks and projections", fountain,
         False),
]
