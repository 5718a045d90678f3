"""The third stage's line about what a user sees: the demo, rviz, the keys, the data."""

import os
import re
import subprocess

from acceptance.common import BUILD, DEVEL, PROGRAMS, ROOT, Line, Skipped, fresh_folder, free_port, run
from acceptance.node_tests import node_tests
from acceptance.users import ended, judge

STEPS_BEFORE = 743  # of the demo's build, when it built everything
MAX_SHARE_OF_STEPS = 0.60
# What came after those steps were counted, and is counted apart: the store, the exports, localising, what is made
# after the drive (PCL), the pages, calibrations corrected.
LATER_PARTS = re.compile(
    r"src/(io/(map_store|export_(bundler|colmap|kitti|nvm)|colmap_camera|undistort_image)"
    r"|merging/(localizer|map_keeper_store)|recognition/largest_features|matching/match_(posed|in_range)|dense/|finish/|surface/"
    r"|sim/tour/sample_surface|sfm/refine_intrinsics|scene/session_camera"
    r"|util/(nearest_rows|checksum|load_document|parse_arguments)|geometry/check_calibration"
    r"|app/(map_formats|map_file_list|map_products|store_folder|folder_lock|write_model_files|finish_map|write_page|web_|map_web|live_|thumbnail)"
    r"|report/(collect_model|name_pictures|drive_names|page_data)"
    r"|ros/(map_store_files|map_web|web_server|live_|mapping_control|finish_actions|map_finisher|product_"
    r"|taken_map|export_folder))\w*\.cc$|srv/(Load|Save)Map|action/|(Densify|ReconstructSurface)\w*\.msg")
MIN_COLOURED_SHARE = 0.005
ROBOTS = "north,south,east,west"
NODE_TESTS = ("teleop", "live_defaults", "mapping_publish", "camera_launch")


def demo_build():
    """An outcome: how many steps a first build of the demo takes, and whether any test is among them."""
    commands = run("ninja", "-C", BUILD, "-t", "commands", "rovio_sfm_demo").splitlines()
    later = sum(LATER_PARTS.search(command) is not None for command in commands)
    tests = [command for command in commands if "_test.cc" in command or "/benchmark/" in command]
    steps = len(commands) - later
    return (f"{steps} steps of {STEPS_BEFORE} build the demo, and {later} of later parts",
            steps <= MAX_SHARE_OF_STEPS * STEPS_BEFORE and not tests, f"{len(tests)} of tests")


def rviz():
    """Four robots whose maps stay apart, the last one's pictures chosen."""
    picture = fresh_folder("eye/rviz.png")
    text = run("xvfb-run", "-a", "-s", "-screen 0 1280x800x24", DEVEL / "env.sh", "/usr/bin/python3",
               ROOT / "scripts/acceptance/rviz_view.py", picture, "--robots", ROBOTS, timeout_s=600,
               env={**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}", "ROS_IP": "127.0.0.1"})
    figures = re.search(r"maps (\d+) coloured ([\d.]+) image (\w+)", text)
    holds = (int(figures[1]) == len(ROBOTS.split(",")) and float(figures[2]) >= MIN_COLOURED_SHARE
             and figures[3] == "True")
    return holds, f"{figures[0]} ({picture})"


def datasets():
    status, text = ended(ROOT / "scripts/datasets")
    return status == 0, f"{text.count('holds')} data sets as they should be"


def slow_demo(_quick):
    """The demo on one core beside a busy process; it must say how far it is."""
    with subprocess.Popen(["taskset", "-c", "0", "sh", "-c", "while :; do :; done"]) as busy:
        try:
            done = subprocess.run(["taskset", "-c", "0", ROOT / "scripts/demo", "--no-install", "--out",
                                   fresh_folder("eye/demo")],
                                  capture_output=True, text=True, timeout=3600, check=False)
        finally:
            busy.kill()
    told = len(re.findall(r"(?m)^ *\d+ s  .*at stop \d+ of \d+", done.stdout))
    tail = "; ".join(done.stdout.strip().splitlines()[-10:])
    return done.returncode == 0 and told >= 5, f"status {done.returncode}, progress told {told} times; {tail}"


def eye(quick):
    if not (PROGRAMS / "mapping").exists():
        raise Skipped("mapping is not built")
    outcomes = [demo_build()]
    if not quick:
        outcomes += [(name, *node_tests(name)) for name in NODE_TESTS]
        outcomes += [("rviz", *rviz()), ("data sets", *datasets())]
    return judge(outcomes)


LINES = [
    Line("eye", "8. for the eye: the demo's build <= 60 % of 743 steps; keys, stream and parallax, topics of a "
         "camera, all paths and maps in rviz; data sets with their sources", eye, True),
    Line("slow_demo", "the demo on one core beside a busy process: exit status 0, and it says how far it is",
         slow_demo, False),
]
