"""The third stage's line about a package that others build, and cameras that are no Rovio's."""

import json
import os
import pathlib
import subprocess

from acceptance.common import PROGRAMS, ROOT, Line, Skipped, fresh_folder, run

BAGS = pathlib.Path(os.environ.get("ROVIO_SFM_CASES", ROOT / "../shared/cases")).resolve() / "bags"
ODD_BAGS = ("plumb_bob_8_zeros", "rational_polynomial_zeros", "roi_full_image")
IMAGES_OF_A_BAG = 8
INSTALLED = ("demo_graph.py", "run_demo.py", "plot_map.py", "teleop", "map_images", "replay", "mapping")


def odd_bags():
    """camera_info that is valid but odd, through replay."""
    if not BAGS.is_dir():
        raise Skipped(f"no cases {BAGS} (set ROVIO_SFM_CASES)")
    registered = {}
    for name in ODD_BAGS:
        out = fresh_folder(f"package/{name}")
        subprocess.run([PROGRAMS / "replay", BAGS / f"{name}.bag", "--out", out, "--mode", "every",
                        "--places", "none"], capture_output=True, check=False)
        registered[name] = count_poses(out / "trajectory.txt")
    return (all(count == IMAGES_OF_A_BAG for count in registered.values()),
            ", ".join(f"{name} {count} of {IMAGES_OF_A_BAG}" for name, count in registered.items()))


def count_poses(path):
    return sum(not line.startswith("#") for line in path.open()) if path.exists() else 0


def workspaces():
    done = subprocess.run([ROOT / "test/scripts/workspace_test.py"], capture_output=True, text=True,
                          check=False)
    return done.returncode == 0, "workspaces configure" if done.returncode == 0 else done.stderr[-400:]


def built_and_installed():
    """A user's build (no -Werror, no tests) of all programs, installed, and run where the sources are not
    mentioned."""
    build, prefix = fresh_folder("package/build"), fresh_folder("package/install")
    run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCATKIN_ENABLE_TESTING=OFF",
        f"-DCATKIN_DEVEL_PREFIX={build / 'devel'}", f"-DCMAKE_INSTALL_PREFIX={prefix}")
    run("cmake", "--build", build, timeout_s=4 * 3600)
    run("cmake", "--install", build)
    programs = prefix / "lib/rovio_sfm"
    problems = [f"{path.name} holds {ROOT}" for path in sorted(programs.iterdir())
                if str(ROOT).encode() in path.read_bytes()]
    problems += [f"{name} is not installed" for name in INSTALLED if not (programs / name).exists()]
    headers = {path.name for path in (prefix / "include").rglob("*.h")}
    messages = {path.stem for folder in ("msg", "srv") for path in (ROOT / folder).iterdir()}
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
    parts = [odd_bags()]
    if not quick:
        parts += [workspaces(), built_and_installed()]
    return all(holds for holds, _ in parts), "; ".join(
        figures + ("" if holds else " (falls)") for holds, figures in parts)


LINES = [
    Line("package", "9. a package that others build and install: without tests, beside another, with clang, no "
         "path of the sources; odd but valid camera_info is taken", package, True),
]
