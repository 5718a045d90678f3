"""The third stage's line about a package that others build, and cameras that are no Rovio's."""

import json
import pathlib
import tempfile

from acceptance.common import ROOT, Line, fresh_folder, run
from acceptance.users import case, ended, judge, program

ODD_BAGS = ("plumb_bob_8_zeros", "rational_polynomial_zeros", "roi_full_image")
IMAGES_OF_A_BAG = 8
INSTALLED = ("demo_graph.py", "run_demo.py", "plot_map.py", "read_plainly.py", "teleop", "map_images", "replay", "mapping")


def odd_bag(name):
    """camera_info that is valid but odd, through replay."""
    out = fresh_folder(f"package/{name}")
    program("replay", case(f"bags/{name}.bag"), "--out", out, "--mode", "every", "--places", "none")
    poses = count_poses(out / "trajectory.txt")
    return poses == IMAGES_OF_A_BAG, f"{poses} of {IMAGES_OF_A_BAG}"


def count_poses(path):
    return sum(not line.startswith("#") for line in path.open()) if path.exists() else 0


def workspaces():
    status, text = ended(ROOT / "test/scripts/workspace_test.py")
    return status == 0, "configure" if status == 0 else text[-400:]


def built_and_installed():
    """A user's build (no -Werror, no tests) of all programs, installed, and run where the sources are not
    mentioned. Installed outside the repository, where roslaunch would find each launch file twice."""
    with tempfile.TemporaryDirectory() as prefix:
        return installed_into(pathlib.Path(prefix))


def installed_into(prefix):
    build = fresh_folder("package/build")
    run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCATKIN_ENABLE_TESTING=OFF",
        f"-DCATKIN_DEVEL_PREFIX={build / 'devel'}", f"-DCMAKE_INSTALL_PREFIX={prefix}")
    run("cmake", "--build", build, timeout_s=4 * 3600)
    run("cmake", "--install", build)
    programs = prefix / "lib/rovio_sfm"
    problems = [f"{path.name} holds {ROOT}" for path in sorted(programs.iterdir())
                if str(ROOT).encode() in path.read_bytes()]
    problems += [f"{name} is not installed" for name in INSTALLED if not (programs / name).exists()]
    headers = {path.name for path in (prefix / "include").rglob("*.h")}
    messages = {path.stem for folder in ("msg", "srv", "action") for path in (ROOT / folder).iterdir()}
    problems += [f"header {name} is installed" for name in sorted(headers)
                 if not any(name.startswith(message) for message in messages)]
    problems += run_installed(prefix)
    return not problems, "; ".join(problems[:5]) or f"{len(list(programs.iterdir()))} files installed"


def run_installed(prefix):
    """An installed tour, rendered and mapped with the installed place model."""
    tour, out = fresh_folder("package/tour"), fresh_folder("package/map")
    programs = prefix / "lib/rovio_sfm"
    run(programs / "rovio_sim", "--render", "visionlab", "--frames", 8, "--out", tour, cwd="/")
    run(programs / "map_images", tour, "--out", out, "--mode", "every", cwd="/")
    summary = json.loads((out / "summary.json").read_text())
    return [] if summary["registered"] == 8 else [f"installed: {summary['registered']} of 8 registered"]


def package(quick):
    outcomes = [(name, *odd_bag(name)) for name in ODD_BAGS]
    if not quick:
        outcomes += [("workspaces", *workspaces()), ("built and installed", *built_and_installed())]
    return judge(outcomes)


LINES = [
    Line("package", "9. a package that others build and install: without tests, beside another, with clang, no "
         "path of the sources; odd but valid camera_info is taken", package, True),
]
