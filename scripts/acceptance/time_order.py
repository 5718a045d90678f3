"""Section 3 of the third stage: repeated, late and missing stamps, clocks and bags that jump."""

import re

from acceptance.common import PROGRAMS, ROOT, Line, Skipped, fresh_folder, run

CASES = ROOT / "../shared/cases"
LOOP = """
import sys, rosbag, rospy
with rosbag.Bag(sys.argv[1]) as old, rosbag.Bag(sys.argv[2], "w") as new:
    shift = rospy.Duration(old.get_end_time() - old.get_start_time() + 1.0)
    for lap in range(2):
        for topic, message, time in old.read_messages():
            new.write(topic, message, time + shift * lap)
"""


def replay(name, bag, *options):
    """What replay prints, and the stamps of every trajectory that it writes."""
    if not bag.exists():
        raise Skipped(f"no bag {bag}")
    out = fresh_folder(f"time/{name}")
    text = run(PROGRAMS / "replay", bag, "--out", out, "--mode", "every", "--places", "none", *options,
               check=False)
    return text, [stamps_of(path) for path in sorted(out.glob("trajectory*.txt"))]


def stamps_of(path):
    return [line.split()[0] for line in path.read_text().splitlines() if not line.startswith("#")]


def is_one_drive(text, trajectories):
    found = re.search(r"(\d+) sessions?; (\d+) images? posed", text)
    figures = f"{found[2]} images in {found[1]} sessions" if found else text.strip()[-200:]
    rises = all(len(set(stamps)) == len(stamps) for stamps in trajectories)
    return bool(found) and found.groups() == ("1", "8") and rises, figures


def looped():
    """A bag that was played twice in a row while it was recorded: its stamps begin anew."""
    bag = fresh_folder("time/loop.bag")
    bag.unlink(missing_ok=True)
    run("/usr/bin/python3", "-c", LOOP, CASES / "bags/good.bag", bag)
    text, trajectories = replay("loop", bag, "--overwrite")
    found = re.search(r"(\d+) sessions?;", text)
    return (bool(found) and found[1] == "2" and all(len(set(s)) == len(s) for s in trajectories),
            f"looped: {found[1] if found else 'no'} sessions")


def check(_quick):
    results = {name: is_one_drive(*replay(name, CASES / f"bags/{name}.bag"))
               for name in ("image_twice", "camera_info_last_digit")}
    results["stamps_zero --stamps bag"] = is_one_drive(
        *replay("stamps_zero", CASES / "bags/stamps_zero.bag", "--stamps", "bag"))
    told, _ = replay("stamps_zero_told", CASES / "bags/stamps_zero.bag")
    results["stamps_zero"] = ("--stamps bag" in told, "told" if "--stamps bag" in told else "NOT TOLD")
    results["loop"] = looped()
    clock = run(PROGRAMS / "rovio_test", "--gtest_filter=*Clock*")
    results["driver"] = ("[  PASSED  ]" in clock, clock.strip().splitlines()[-1])
    return all(holds for holds, _ in results.values()), "; ".join(
        f"{name}: {figures}" for name, (_, figures) in results.items())


LINES = [
    Line("time_order", "3: a repeated image, K's ninth digit, stamps of zero and a looped bag are one drive each, "
         "told; no trajectory has equal stamps; the driver runs on the steady clock", check, True),
]
