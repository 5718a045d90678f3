"""The lines about speed with all nodes up, nothing beside them: images that come at an even rate, and when their
poses are told."""

import json
import pathlib
import re
import subprocess

from acceptance.common import ROOT, Line, dataset, fresh_folder
from acceptance.users import Master

FEEDER = ROOT / "scripts/acceptance/live_feed.py"
FAST = ROOT / "config/frontend_fast.yaml"
TOPIC = "/eye/image_raw"
WANTED = {"every": 7, "parallax": 25}  # images a second
MAX_HELD, MIN_POSED = 0.2, 0.95  # shares: of all until the map began, of the others
MAX_LATE_S = 0.5  # of 95 % of the poses
MAX_MB = 2048  # of all nodes together


def peak_mb(parent):
    """Of all processes that it started, together."""
    children = subprocess.run(["pgrep", "-P", str(parent)], capture_output=True, text=True, check=False).stdout.split()
    peaks = (re.search(r"VmHWM:\s+(\d+)", pathlib.Path(f"/proc/{child}/status").read_text()) for child in children)
    return sum(int(peak[1]) for peak in peaks if peak) / 1024 + sum(map(peak_mb, children))


def judge(rate_hz, late_s, wanted_hz, peak):
    """From the first pose on: while a map begins its frames are held, and posed together later."""
    num_held = next((number for number, late in enumerate(late_s) if late is not None), len(late_s))
    posed = sorted(late for late in late_s[num_held:] if late is not None)
    if not posed:
        return False, "no image was posed"
    p95 = posed[int(0.95 * (len(posed) - 1))]
    holds = (rate_hz >= 0.99 * wanted_hz and num_held <= MAX_HELD * len(late_s) and p95 <= MAX_LATE_S and peak <= MAX_MB
             and len(posed) >= MIN_POSED * (len(late_s) - num_held))
    return holds, (f"{rate_hz:.1f} images a second; {num_held} of {len(late_s)} held until the map began, {len(posed)} of the "
                   f"others posed, {posed[len(posed) // 2]:.2f} s after the image in the median, {p95:.2f} s for 95 %; peak of "
                   f"all nodes {peak:.0f} MB")


def live(mode):
    def check(_quick):
        source = dataset("tum_fr1_xyz")
        out = fresh_folder(f"live/{mode}")
        with Master(f"live_{mode}") as master:
            nodes = master.start("roslaunch", "rovio_sfm", "camera.launch", "robot:=eye", f"image:={TOPIC}",
                                 "image_transport:=compressed", f"calibration:={source / 'calibration.txt'}", "odom:=none",
                                 f"mode:={mode}", f"config:={FAST}", f"output_dir:={out}")
            said = master.run("/usr/bin/python3", FEEDER, source, TOPIC, WANTED[mode], timeout_s=900)
            peak = peak_mb(nodes.pid)
            if said.status != 0:
                raise RuntimeError(said.text[-300:] + master.text_of(nodes)[-300:])
        fed = json.loads(said.text.strip().splitlines()[-1])
        return judge(fed["rate_hz"], fed["late_s"], WANTED[mode], peak)
    return check


LINES = [Line(f"live_{mode}", f"all nodes up, config/frontend_fast.yaml, tum_fr1_xyz, mode {mode}, {rate} images a second: once "
              f"the map began >= 95 % posed, 95 % of them within {MAX_LATE_S} s, <= 2 GiB", live(mode), False)
         for mode, rate in WANTED.items()]
