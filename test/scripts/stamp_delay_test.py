#!/usr/bin/python3
"""Tests of scripts/stamp_delay.py: a drive round a circle whose pictures are stamped 20 ms early."""

import math
import pathlib
import sqlite3
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/stamp_delay.py"
START_S, PERIOD_S, DELAY_S, POSES, KEYFRAMES = 1000, 0.1, 0.02, 100, 20


def pose_at(stamp_s, told_s):
    """A line of a TUM trajectory: 1 m round the origin, faster and faster."""
    angle = 0.05 * (stamp_s - START_S) ** 2
    return f"{told_s:.6f} {math.cos(angle):.9f} {math.sin(angle):.9f} {0.1 * math.sin(3 * angle):.9f} 0 0 0 1\n"


class StampDelay(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.truth = self.folder / "groundtruth.txt"
        self.truth.write_text("".join(pose_at(t, t) for t in (START_S - 1 + 0.01 * i for i in range(1300))))
        stamps = [START_S + PERIOD_S * i for i in range(POSES)]
        (self.folder / "trajectory.txt").write_text("".join(pose_at(t + DELAY_S, t) for t in stamps))
        self.write_store(stamps[:KEYFRAMES])

    def write_store(self, stamps):
        with sqlite3.connect(self.folder / "map.db") as database:
            database.executescript("DROP TABLE IF EXISTS frame; DROP TABLE IF EXISTS keyframe;"
                                   "CREATE TABLE frame (id INTEGER, stamp_ns INTEGER); CREATE TABLE keyframe (frame INTEGER)")
            for number, stamp in enumerate(stamps):
                database.execute("INSERT INTO frame VALUES (?, ?)", (number, round(1e9 * stamp)))
                database.execute("INSERT INTO keyframe VALUES (?)", (number,))

    def run_script(self):
        return subprocess.run([SCRIPT, self.folder, self.truth, "--most", "30", "--step", "10"],
                              capture_output=True, text=True, check=False)

    def test_finds_the_delay_and_what_is_left(self):
        said = self.run_script()
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("  20 ms: all 0.00 cm, keyframes 0.00 cm", said.stdout)
        self.assertIn("least of the keyframes: 20 ms", said.stdout)
        self.assertNotIn("   0 ms: all 0.00 cm", said.stdout)

    def test_says_what_is_missing(self):
        self.write_store([])
        said = self.run_script()
        self.assertEqual(said.returncode, 2)
        self.assertIn("0 keyframes with a pose", said.stderr)
        (self.folder / "map.db").unlink()
        self.assertIn("map.db: no such file", self.run_script().stderr)


if __name__ == "__main__":
    unittest.main()
