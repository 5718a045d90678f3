"""The lines about tours as the robot's own camera sees them."""

import math

from acceptance.common import PROGRAMS, Line, map_images, percent, run
from acceptance.renders import Render, folder_name, render
from acceptance.stage_1 import TOURS

SEEDS = (1, 2, 3)
AUDITED = ("visionlab", "engineRoom0", "turntable")
STEPS = {"visionlab": 2, "industrialArea": 2}  # whose own are shorter than the robot's, 15 to 40 px
MIN_REGISTERED = 95  # per cent
# Error in per cent of the path, rotation in degrees, the roll about the path apart: the issue's.
BARS = {name: (0.3, 0.6) for name in TOURS}
SCALE_SEEDS, SCALE_FRAMES = range(1, 21), 30
EVENING = 3  # --light of the second drive


def audit(quick):
    """Figures of design 5.6; those that fall are named."""
    fallen, count = [], 0
    for name in AUDITED[:1] if quick else AUDITED:
        lines = run(PROGRAMS / "rovio_sim", "--audit", name, "--steps", STEPS.get(name, 1),
                    check=False).splitlines()
        count += len(lines)
        fallen += [f"{name}: {' '.join(line.split())}" for line in lines if not line.startswith("holds")]
    return count > 0 and not fallen, "; ".join(fallen) or f"{count} figures"


def share(summary):
    """Error in per cent of the path; without poses infinite."""
    error, path = summary["ate_rmse_m"], summary["path_length_m"]
    return percent(error, path) if error is not None and path else float("inf")


def mapped(wanted, bars):
    """Whether one session has nearly all pictures of a render within the bars, and the figures."""
    s = map_images(f"maps/robot_{folder_name(wanted, wanted.noise)}", [render(wanted)])
    errors = s["evaluation"] or {}
    rotation, roll = (errors.get(name, float("inf")) for name in ("rotation_rmse_after_roll_deg", "roll_deg"))
    holds = (percent(s["registered"], s["frames"]) >= MIN_REGISTERED and s["sessions"] == 1
             and share(s) <= bars[0] and rotation <= bars[1])
    return holds, (f"seed {wanted.seed}: {s['registered']} of {s['frames']}, {share(s):.3f} %, {rotation:.2f} deg "
                   f"and {roll:.2f} of roll, {s['sessions']} session{'s' * (s['sessions'] != 1)}")


def tour(name, movers=False):
    def check(quick):
        seeds = SEEDS[:1] if quick or movers else SEEDS
        wanted = [Render(name, seed=seed, steps=STEPS.get(name, 1), movers=movers) for seed in seeds]
        results = [mapped(one, BARS[name]) for one in wanted]
        return all(holds for holds, _ in results), "; ".join(text for _, text in results)
    return check


def other_light(light):
    def check(_quick):
        folders = [render(Render("engineRoom0")), render(Render("engineRoom1", light=light))]
        s = map_images(f"merge/robot_engine_rooms_light{light}", folders, "--max-overlaps", 1)
        holds = s["maps"] == 1 and percent(s["registered"], s["frames"]) >= MIN_REGISTERED and share(s) <= 0.3
        return holds, (f"{s['registered']} of {s['frames']} in the largest of {s['maps']} maps, {share(s):.3f} %, "
                       f"overlaps: {s['merges']['accepted']} accepted, {s['merges']['refused']} refused")
    return check


def sigmas(_quick):
    """Of the scale, from the driver's odometry: neither too small nor too large."""
    ratios = []
    for seed in SCALE_SEEDS:
        s = map_images(f"maps/robot_scale_seed{seed}", [render(Render("visionlab", seed=seed, frames=SCALE_FRAMES))])
        ratios.append(s["scale_error"] / s["scale_sigma"] if s["metric"] else float("inf"))
    rms = math.sqrt(sum(ratio**2 for ratio in ratios) / len(ratios))
    return 0.4 <= rms <= 1.3, f"RMS of error over sigma {rms:.2f}, the worst {max(ratios):.2f}"


LINES = [
    Line("audit", "robot camera: the simulator's audit holds in three tours", audit, True),
    *(Line(f"tour_{name}", f"robot camera, {name}, three seeds: >= 95 % registered, one session, <= {BARS[name][0]} % of the "
           f"path, <= {BARS[name][1]} deg", tour(name), name == "visionlab") for name in TOURS),
    Line("movers", "robot camera, visionlab with two people who walk there: the same bars", tour("visionlab", True), False),
    Line("scale", f"robot camera: visionlab, {SCALE_FRAMES} pictures, 20 seeds: RMS of the scale's error over its sigma "
         "0.4 to 1.3", sigmas, False),
    Line("engine_rooms", "robot camera: engineRoom0 + 1 merged from one overlap, <= 0.3 % of the path", other_light(0), False),
    Line("engine_rooms_evening", "the same, the second drive in another light", other_light(EVENING), False),
]
