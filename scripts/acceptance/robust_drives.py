"""The lines of the robustness table (docs/robustness.md)."""

import re

from acceptance.common import THREADS, Line
from tables import robust

PICTURES = r"^(JPEG|noise|blur|exposure)"
QUICK = r"^(JPEG of quality 25|wheels)"


def rows(chosen):
    def check(quick):
        wanted = [row for row in robust.ROWS if bool(re.search(PICTURES, row.name)) == (chosen == "pictures")
                  and (not quick or re.search(QUICK, row.name))]
        fallen = []
        for row in wanted:
            held, cells = robust.judge_row(row, THREADS)
            if not held:
                fallen.append(f"{row.name}: {cells[1]}, {cells[-1]}")
        return not fallen, "; ".join(fallen) or f"{len(wanted)} rows hold"
    return check


LINES = [
    Line("robust_pictures", "robustness: JPEG, noise, blur and exposure bend no map; >= 90 % where it must", rows("pictures"),
         True),
    Line("robust_drives", "robustness: dropped images, turns, planes, movers, standing, wheels bend no map", rows("drives"),
         True),
]
