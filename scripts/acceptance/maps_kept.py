"""A map is never lost (issue 9, section 1): what programs keep that are ended in the middle.

As a program it prints the table of docs/maps_kept.md: scripts/accept 3 --only maps_kept writes it."""

import pathlib
import re
import subprocess
import tempfile

from acceptance import live_mapping
from acceptance.common import PROGRAMS, ROOT, WORK, Line, dataset, fresh_folder, run
from acceptance.endings import (Running, disk, end, environment, frames_below, frames_of, names_in,
                                size_of)
from acceptance.reasons import cases

TABLE = ROOT / "docs/maps_kept.md"
HOW = ("kill", "once", "twice", "full", "read-only")
HEADINGS = ("kill -9", "Ctrl-C once", "Ctrl-C twice", "full disk", "read-only folder")
ROSLAUNCH_S = 15.0  # after which it sends the next signal
DISK = "size=400m"
STARTED_BYTES = 6 << 20  # a store that holds some twenty frames
MAP = ("--mode", "parallax", "--places", "none", "--threads", "2")


def bag():
    """A drive of 200 images, made once."""
    path = WORK / "kept_drive.bag"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        run(PROGRAMS / "images_to_bag", dataset("tum_fr1_xyz"), path, "--stride", 4)
    return path


def images_of(name):
    return dataset(name) / "images"


# A program: its arguments into a folder, and when it is in the middle.
TOOLS = {
    "replay": (lambda out: (bag(), "--out", out / "map", *MAP),
               lambda out: size_of(out) > STARTED_BYTES),
    "map_images": (lambda out: (dataset("tum_fr1_xyz"), "--stride", 4, "--out", out / "map", *MAP),
                   lambda out: size_of(out) > STARTED_BYTES),
    "train_places": (lambda out: (images_of("tum_fr1_rpy"), "--out", out / "model.places", "--images", 60,
                                  "--words", 2000, "--features", 500),
                     lambda out: (out / "model.places.work/words.bin").exists()),
    "images_to_bag": (lambda out: (dataset("tum_fr1_xyz"), out / "drive.bag"),
                      lambda out: size_of(out) > STARTED_BYTES),
}


def end_tool(program, how):
    """(status, seconds, words, files, frames in its store) of a program that is ended so."""
    arguments, is_started = TOOLS[program]
    with disk(DISK + (",ro" if how == "read-only" else "")) as out:
        with Running(program, *arguments(out)) as running:
            if how != "read-only" and not running.wait_until(lambda: is_started(out)):
                raise RuntimeError(f"{program} ended too soon: {running.said()[-300:]}")
            status, seconds = end(running, how, out)
            return status, seconds, running.said(), names_in(out), frames_below(out)


def is_right(program, how, status, seconds, said, files, frames):
    if how == "read-only":
        return status == 1 and "Read-only file system" in said and seconds < ROSLAUNCH_S
    if how == "kill":
        return status == 137 and bool(files) and (program in WITHOUT_STORE or frames > 0)
    if how == "full":
        return status == 1 and "No space left on device" in said
    if program == "mapping":
        stopped = (0, 130) if how == "twice" else (0,)
    else:
        stopped = (130,)
    # A second signal may come before the map is written as files: then the store has it.
    is_kept = any(re.search(KEPT[program], name) for name in files) or (how == "twice" and frames > 0)
    return status in stopped and seconds < ROSLAUNCH_S and is_kept


KEPT = {"mapping": r"trajectory\.txt$", "replay": r"trajectory\.txt$", "map_images": r"trajectory\.txt$",
        "train_places": r"\.work/words\.bin$", "images_to_bag": r"drive\.bag$"}
WITHOUT_STORE = ("train_places", "images_to_bag")


def measure(program, how):
    if program == "mapping":
        return live_mapping.end_mapping(how, bag(), DISK)
    return end_tool(program, how)


def cell(status, seconds, files):
    # What the disk of a process that was ended holds, without folders.
    names = ", ".join(sorted({pathlib.Path(name).name for name in files if not name.endswith(".lock")}))
    return f"{status}, {seconds:.0f} s: {names or 'nothing was there'}"


def table(_quick):
    """Ends every program in every way, and writes the table."""
    fallen, rows = [], []
    for program in ("mapping", *TOOLS):
        cells = []
        for how in HOW:
            status, seconds, said, files, frames = measure(program, how)
            cells.append(cell(status, seconds, files))
            if not is_right(program, how, status, seconds, said, files, frames):
                fallen.append(f"{program}, {how}: {status} after {seconds:.1f} s, {files}, {frames} frames in the "
                              f"store, {said[-200:]!r}")
        rows.append([f"`{program}`", *cells])
    write_table(rows)
    return not fallen, "; ".join(fallen) or f"{len(rows) * len(HOW)} endings, {TABLE.relative_to(ROOT)}"


def write_table(rows):
    text = TABLE.read_text()
    head = text[:text.index("| program |")] if "| program |" in text else text.rstrip() + "\n\n"
    lines = [" | ".join(("| program", *HEADINGS)) + " |", "|---" * (len(HEADINGS) + 1) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    TABLE.write_text(head + "\n".join(lines) + "\n")


def overwrite(_quick):
    """Nothing is replaced unasked; what is replaced leaves nothing, and what is the user's; nothing
    registered is status 2."""
    out = fresh_folder("kept_overwrite")
    options = ("--out", out, "--mode", "every", "--places", "none")
    run(PROGRAMS / "map_images", cases() / "good7", *options, "--format", "tum,ply,ply_ascii,kitti,colmap,nvm,report")
    older = [path for path in names_in(out) if "kitti" in path or "colmap" in path or "nvm" in path]
    mine = ["trajectory_true.txt", "map_2/cloud.ply", "kitti/notes.txt"]
    (out / "map_2").mkdir()
    for name in mine:
        (out / name).write_text("mine")
    refused = subprocess.run([str(word) for word in (PROGRAMS / "map_images", cases() / "good7", *options)],
                             capture_output=True, text=True, check=False)
    run(PROGRAMS / "map_images", cases() / "good7", *options, "--overwrite")
    written = {"map.db", "map.db.lock", "map.db-shm", "map.db-wal", "map_files.txt", "summary.json", "trajectory.txt",
               "cloud.ply"}
    left = [name for name in names_in(out) if name not in written and name not in mine]
    lost = [name for name in mine if name not in names_in(out)]
    black = subprocess.run([str(word) for word in (PROGRAMS / "map_images", cases() / "black", *options[2:],
                                                   "--out", fresh_folder("kept_black"))],
                           capture_output=True, text=True, check=False)
    holds = (refused.returncode == 1 and "exists" in refused.stderr and len(older) > 7 and not left and not lost
             and black.returncode == 2
             and "no image was registered" in black.stdout)
    return holds, f"unasked {refused.returncode}; left of {len(older)} by the older run: {left}; lost: {lost}; black {black.returncode}"


def replacing(_quick):
    """--overwrite takes the older map away only when there is something in its place."""
    out = fresh_folder("kept_replacing")
    command = (cases() / "good7", "--out", out, "--mode", "every", "--places", "none")
    run(PROGRAMS / "map_images", *command)
    before, replaced = frames_of(out / "map.db"), out / "map.db.replaced"
    with Running("map_images", *command, "--overwrite") as running:
        began = running.wait_until(replaced.exists)
        status, _ = end(running, "kill", out)
    kept = frames_of(replaced) if replaced.exists() else frames_of(out / "map.db")
    run(PROGRAMS / "map_images", *command, "--overwrite")
    after = frames_of(out / "map.db")
    holds = began and status == 137 and before == kept == after > 0 and not replaced.exists()
    return holds, (f"{before} frames; {kept} after kill -9 of a run that replaces them; {after} after a whole one, "
                   f"beside it {names_in(out)}")


def defaults(_quick):
    """replay without --out writes below ROS_HOME and says where."""
    with tempfile.TemporaryDirectory() as home:
        done = subprocess.run([str(PROGRAMS / "replay"), str(cases() / "bags/good.bag"), "--mode", "every",
                               "--places", "none"], capture_output=True, text=True, check=False,
                              env=environment(1, home))
        found = list(pathlib.Path(home).glob("rovio_sfm/*/trajectory.txt"))
        told = bool(found) and str(found[0].parent) in done.stdout
    return done.returncode == 0 and len(found) == 1 and told, f"{done.returncode}, {len(found)} trajectory"


LINES = [
    Line("maps_kept", "kill, Ctrl-C once and twice, a full disk, a read-only folder in mapping, replay, "
         "map_images, train_places, images_to_bag: what was reached is kept", table, False),
    Line("overwrite", "--overwrite leaves nothing of the older run; nothing registered is exit status 2",
         overwrite, True),
    Line("replacing", "--overwrite, killed right after its start, leaves the older map", replacing, True),
    Line("default_folder", "replay without a folder writes below ROS_HOME and says where", defaults, True),
    Line("relative_folder", "mapping: ~ is expanded, a relative folder refused, export_map from six clients at "
         "once", live_mapping.folders, False),
]
