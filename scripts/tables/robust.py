"""The rows of docs/robustness.md."""

import functools
from typing import Callable, NamedTuple, Optional

from acceptance.renders import Render, render
from tables import disturb
from tables.bending import judge
from tables.runs import Setting, map_with

FRAMES, EVENT = 40, 15  # of the undisturbed drive; the picture at which things happen
MIN_REGISTERED = 0.9
OWN_TOUR = """name: {name}
world: laboratory
head_position: 65
interval_s: 2.0
step_spread: 0.12
exposure: 0.75
exposure_stops: 0
way_points:
"""
PARALLAX = Setting(words=("--mode", "parallax"))


class Row(NamedTuple):
    name: str
    make: Callable  # () -> folder of pictures
    event: Optional[tuple] = None  # (first, last) spoilt picture, by its number among those that are there
    whole: bool = False  # at least 90 % of the pictures must be registered
    scale: bool = False  # the true scale inside 2 sigma, or not metric
    setting: Setting = Setting()


@functools.lru_cache(maxsize=None)
def drive():
    """The undisturbed one: the first pictures of visionlab, each pixel sharp and without noise."""
    return disturb.read(render(Render("visionlab", camera="plain", frames=FRAMES), clean=True))


def own_tour(name, points):
    """points: (x_m, y_m, yaw_deg, frames)."""
    text = OWN_TOUR.format(name=name) + "".join(
        f"  - {{x_m: {x}, y_m: {y}, yaw_deg: {yaw}{f', frames: {frames}' if frames else ''}}}\n"
        for x, y, yaw, frames in points)
    return render(Render(name, camera="plain", config=text), clean=True)


def turning(angle):
    """Forward, a turn on the spot in steps of 9 degrees, and on in the same direction."""
    steps = angle // 9
    return own_tour(f"turning_{angle}", [(0.9, 1.35, -2, 0), (2.2, 1.75, 0, 15), (2.2, 1.75, angle, steps),
                                         (3.5, 1.45, angle, 15)])


def sideways():
    return own_tour("sideways", [(2.6, 1.3, 88, 0), (4.6, 1.3, 92, 39)])


def before_a_board():
    """Towards a printed board, along it so near that it fills the view for 20 pictures, and back."""
    tour = own_tour("before_a_board", [(0.9, 1.35, 0, 0), (3.8, 1.3, 0, 36), (3.8, 1.75, 0, 20), (2.6, 1.6, 0, 15)])
    return disturb.board(disturb.read(tour), "board", 4.4, (0.95, 2.1), (0.0, 0.62))


def made(function, *arguments):
    """Of the undisturbed drive."""
    return lambda: function(drive(), f"{function.__name__}_{'_'.join(str(word) for word in arguments)}", *arguments)


ROWS = [
    *(Row(f"JPEG of quality {q}", made(disturb.jpeg, q), whole=q >= 25) for q in (100, 80, 50, 25, 15)),
    *(Row(f"noise of σ {s} grey levels", made(disturb.noise, s), whole=s <= 15) for s in (5, 10, 15, 20)),
    *(Row(f"blur of σ {s} px", made(disturb.blur, s), whole=s <= 1.5) for s in (1.0, 1.5, 2.0, 3.0)),
    *(Row(f"{n} dropped in a row", made(disturb.dropped, EVENT, n), (EVENT, EVENT - 1)) for n in (1, 2, 3, 5, 7, 10)),
    *(Row(f"exposure jumps by {s} stop{'s' * (s > 1)}", made(disturb.exposure, s, 5)) for s in (1, 2)),
    Row("movers over a third of the view", made(disturb.movers, EVENT, EVENT + 15, 14), (EVENT, EVENT + 14)),
    *(Row(f"turn of {a}° on the spot", functools.partial(turning, a), (16, 15 + a // 9)) for a in (90, 180, 360)),
    Row("sideways only", sideways),
    Row("a plane fills the view for 20 pictures", before_a_board, (37, 56)),
    Row("standing still for 500 images", made(disturb.standing, EVENT), (EVENT, EVENT + 499), setting=PARALLAX),
    Row("wheels slip by 30 %", made(disturb.slip, EVENT, EVENT + 10, 0.7, 0.0), scale=True),
    Row("a lifted wheel: 5° too much a picture", made(disturb.slip, EVENT, EVENT + 10, 1.0, 5.0), scale=True),
]


def undisturbed(threads):
    return map_with(drive().folder, Setting(), threads)


def undisturbed_row(threads):
    s = undisturbed(threads).summary
    return ("nothing", f"{s['registered']} of {s['frames']}", s["maps"], millimetres(s["ate_rmse_m"]), None, None, None)


def judge_row(row, threads):
    """A row of the table, and whether it holds."""
    base = undisturbed(threads).summary
    pictures = row.make()
    run = map_with(pictures, row.setting, threads)
    s = run.summary
    bound_m = max(1.5 * base["ate_rmse_m"], 0.003 * (s["path_length_m"] or base["path_length_m"]))
    stamps = [float(line.split()[0]) for line in (pictures / "times.txt").read_text().splitlines() if line[0] != "#"]
    verdict = judge(run.folder, pictures, row.event and tuple(stamps[i] for i in row.event), bound_m)
    why = reasons(row, s, verdict)
    return why == [], (row.name, f"{s['registered']} of {s['frames']}", s["maps"], millimetres(verdict.before_m),
                       millimetres(verdict.after_m), verdict.scale_ratio and f"{verdict.scale_ratio:.3f}",
                       "holds" if not why else "**FALLS**: " + ", ".join(why))


def reasons(row, summary, verdict):
    why = ["a map is bent"] if verdict.bent else []
    if summary["registered"] == 0:
        why.append("no map")
    if row.whole and summary["registered"] < MIN_REGISTERED * summary["frames"]:
        why.append("fewer than 90 % registered")
    if row.scale and summary["metric"] and not summary["scale_inside_two_sigma"]:
        why.append("the true scale is outside 2σ")
    return why


def millimetres(value_m):
    return None if value_m is None else f"{1000 * value_m:.1f}"
