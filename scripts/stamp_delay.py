#!/usr/bin/python3
"""How much of a map's error is that pictures and truth tell other times:
  stamp_delay.py MAP TRUTH [--step MS] [--most MS]
MAP: a folder of map_images (map.db and trajectory.txt, one drive); TRUTH: its groundtruth.txt. Prints the error after one
similarity of all poses, and of the keyframes, with all stamps later by each delay, and the delay with the least error of
the keyframes. A shutter that rolls, or stamps taken when a picture is read, show as one delay; a bent map does not."""

import argparse
import pathlib
import sqlite3
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

from acceptance.common import PROGRAMS  # noqa: E402  (after the path is set)
from comparison.measuring import error_of  # noqa: E402  (after the path is set)

TOLERANCE_S = 1e-5  # trajectories have microseconds
STEP_MS, MOST_MS = 5, 40


def poses_of(trajectory):
    """Lines of a TUM trajectory as (stamp in seconds, the rest)."""
    lines = [line for line in trajectory.read_text().splitlines() if line and not line.startswith("#")]
    return [(float(stamp), rest) for stamp, _, rest in (line.partition(" ") for line in lines)]


def keyframes_of(poses, store):
    with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
        rows = database.execute("SELECT stamp_ns FROM keyframe JOIN frame ON frame.id = keyframe.frame").fetchall()
    ticks = {round(stamp_ns * 1e-9 / TOLERANCE_S) + off for (stamp_ns,) in rows for off in (-1, 0, 1)}
    return [pose for pose in poses if round(pose[0] / TOLERANCE_S) in ticks]


def error_with_delay(poses, delay_s, truth):
    """ATE in metres with all stamps later by the delay."""
    with tempfile.TemporaryDirectory() as folder:
        late = pathlib.Path(folder) / "late.txt"
        late.write_text("".join(f"{stamp + delay_s:.6f} {rest}\n" for stamp, rest in poses))
        error = error_of(PROGRAMS / "evaluate_trajectory", truth, late)
    if error is None:
        raise ValueError(f"{truth}: no error of {len(poses)} poses that are {delay_s} s later")
    return error


def errors_by_delay(folder, truth, step_ms=STEP_MS, most_ms=MOST_MS):
    """{delay in ms: (ATE of all poses, of the keyframes), in metres}."""
    poses = poses_of(folder / "trajectory.txt")
    keyframes = keyframes_of(poses, folder / "map.db")
    if len(keyframes) < 3:
        raise ValueError(f"{folder}: {len(keyframes)} keyframes with a pose in trajectory.txt, 3 are needed")
    return {ms: tuple(error_with_delay(part, 1e-3 * ms, truth) for part in (poses, keyframes))
            for ms in range(-most_ms, most_ms + 1, step_ms)}


def best_delay(errors):
    """In ms, by the keyframes."""
    return min(errors, key=lambda ms: errors[ms][1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("map", type=pathlib.Path)
    parser.add_argument("truth", type=pathlib.Path)
    parser.add_argument("--step", type=int, default=STEP_MS, metavar="MS")
    parser.add_argument("--most", type=int, default=MOST_MS, metavar="MS")
    arguments = parser.parse_args()
    for file in (arguments.map / "trajectory.txt", arguments.map / "map.db", arguments.truth):
        if not file.is_file():
            parser.error(f"{file}: no such file")
    try:
        errors = errors_by_delay(arguments.map, arguments.truth, arguments.step, arguments.most)
    except ValueError as error:
        parser.error(str(error))
    for ms, (of_all, of_keyframes) in errors.items():
        print(f"{ms:4} ms: all {100 * of_all:.2f} cm, keyframes {100 * of_keyframes:.2f} cm")
    print(f"least of the keyframes: {best_delay(errors)} ms")


if __name__ == "__main__":
    main()
