"""What is refused says why, where the user looks (issue 9, section 2)."""

import json
import os
import pathlib
import subprocess

from acceptance.common import DEVEL, PROGRAMS, ROOT, Line, Skipped, fresh_folder

CASES = pathlib.Path(os.environ.get("ROVIO_SFM_CASES", ROOT / "../shared/cases")).resolve()
EVERY = ("--mode", "every", "--places", "none")

# Case, what the output must hold, exit status. Bags are replayed, folders mapped.
REFUSED = [
    ("half_size_images", "image of 384x256 px: expected the camera's 768x512", 2),
    ("calibration_other_size", "expected the camera's", 2),
    ("black", "image is of one colour", 2),
    ("bags/camera_info_other_size.bag", "image of 768x512 px: expected the camera's 1536x1024", 2),
    ("bags/no_camera_info.bag", "--calibration", 1),
    ("bags/topics_nested.bag", "/camera/color/image_raw", 1),
    ("bags/topics_capital.bag", "/Robot1/image_raw", 1),
    ("bags/unclosed.bag", "rosbag reindex", 1),
    ("bags/sim_no_tf.bag", "not metric: no tf between rovio1/base_link", 0),
    ("bags/sim_frames_unprefixed.bag", "not metric: no tf between rovio1/base_link", 0),
    ("bags/sim_base_footprint.bag", "not metric: no tf between rovio1/base_link", 0),
    ("bags/sim_odom_quaternion_zero.bag", "quaternion", 0),
]
# Case, options that mend it, what the output must hold.
MENDED = [
    ("bags/no_camera_info.bag", ("--calibration", CASES / "good7/calibration.txt"), "8 images posed"),
    ("bags/topics_nested.bag", ("--image-topic", "/camera/color/image_raw/compressed"), "8 images posed"),
    ("bags/topics_capital.bag", ("--image-topic", "/Robot1/image_raw/compressed"), "8 images posed"),
    ("bags/sim_frames_unprefixed.bag", ("--base-frame", "base_link"), "in metres"),
    ("bags/sim_base_footprint.bag", ("--base-frame", "base_footprint"), "in metres"),
    ("bags/sim_good.bag", (), "in metres"),
]
COUNTED = {"left_out": dict, "tracks": dict, "places": dict, "why_in_map_units": str}


def cases():
    if not CASES.exists():
        raise Skipped(f"no cases {CASES} (set ROVIO_SFM_CASES)")
    return CASES


def map_case(case, *options):
    """Exit status, output and folder of a case that is mapped."""
    source = cases() / case
    out = fresh_folder("case_" + source.name)
    program = "replay" if source.suffix == ".bag" else "map_images"
    done = subprocess.run([str(word) for word in (PROGRAMS / program, source, "--out", out, *EVERY, *options)],
                          capture_output=True, text=True, timeout=600, check=False)
    return done.returncode, done.stdout + done.stderr, out


def offline(_quick):
    """Every case says its reason, on the terminal and, where there is a run, in summary.json."""
    fallen = []
    for case, reason, expected in REFUSED:
        status, said, out = map_case(case)
        if status != expected or reason not in said:
            fallen.append(f"{case}: {status}, {said.strip().splitlines()[-1:]}")
        elif status != 1:
            summary = json.loads((out / "summary.json").read_text())
            kinds = {name: kind for name, kind in COUNTED.items() if not isinstance(summary.get(name), kind)}
            if kinds:
                fallen.append(f"{case}: summary.json lacks {sorted(kinds)}")
    return not fallen, "; ".join(fallen) or f"{len(REFUSED)} cases say why"


def mended(quick):
    """What the reasons recommend does help."""
    chosen = MENDED[:4] if quick else MENDED
    fallen = []
    for case, options, words in chosen:
        status, said, _ = map_case(case, *options)
        if status != 0 or words not in said:
            fallen.append(f"{case} {' '.join(map(str, options))}: {status}, {said.strip().splitlines()[-2:]}")
    return not fallen, "; ".join(fallen) or f"{len(chosen)} cases are mapped with the option that is named"


def programs(_quick):
    """Every program, started wrongly."""
    done = subprocess.run([str(DEVEL / "env.sh"), str(ROOT / "test/scripts/program_refusals_test.py"),
                           str(PROGRAMS)], capture_output=True, text=True, timeout=1200, check=False)
    words = [line for line in done.stderr.splitlines() if line.startswith(("FAIL", "ERROR", "Ran"))]
    return done.returncode == 0, "; ".join(words)


LINES = [
    Line("programs", "every program says why it ends: a bad option, a bad file, no master", programs, False),
    Line("reasons", "what is left out is counted by reason, on the terminal and in summary.json; maps that are "
         "not metric say why", offline, True),
    Line("mended", "the option that a reason names helps: base frame, topics, calibration", mended, True),
]
