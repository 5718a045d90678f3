#!/usr/bin/python3
"""Tests of what the demo makes of time and of pictures, without a graph."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest

import cv2
import numpy

sys.dont_write_bytecode = True
SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
import demo_graph
import demo_pictures


def status(num_events):
    session = types.SimpleNamespace(num_frames=num_events)
    entry = types.SimpleNamespace(num_frames=num_events, num_landmarks=10 * num_events)
    return types.SimpleNamespace(num_events=num_events, sessions=[session], maps=[entry])


class FolderTest(unittest.TestCase):
    def test_a_folder_of_something_else_is_not_emptied(self):
        with tempfile.TemporaryDirectory() as folder:
            mine = pathlib.Path(folder) / "mine.txt"
            mine.write_text("mine")
            done = subprocess.run([sys.executable, SCRIPTS / "run_demo.py", "--out", folder],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(f"{folder}: holds something else", done.stderr)
            self.assertEqual(mine.read_text(), "mine")


class ProgressTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.log, self.now_s = pathlib.Path(folder.name) / "drive_tour.log", 0.0
        self.progress = demo_graph.Progress(0.0, {"rovio1": self.log}, lambda: self.now_s)

    def look(self, now_s, newest):
        self.now_s = now_s
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            self.progress.look(newest)
        return said.getvalue()

    def test_a_slow_drive_is_no_standstill(self):
        for minute in range(1, 30):
            self.look(59.0 * minute, status(minute))
            self.assertFalse(self.progress.has_stalled())

    def test_a_new_stop_is_progress_though_no_frame_came(self):
        self.look(1.0, status(1))
        self.log.write_text("[ INFO] [1]: stop 2 of 75\n")
        self.look(59.0, status(1))
        self.now_s = 100.0
        self.assertFalse(self.progress.has_stalled())

    def test_a_minute_without_anything_new_is_one(self):
        self.look(1.0, status(1))
        self.look(61.5, status(1))
        self.assertTrue(self.progress.has_stalled())

    def test_it_says_every_ten_seconds_how_far_it_is(self):
        self.log.write_text("[ INFO] [1]: stop 2 of 75\n[ INFO] [2]: stop 7 of 75\n")
        self.assertEqual(self.look(9.0, status(7)), "")
        self.assertEqual(self.look(10.0, status(8)),
                         "   10 s  rovio1 at stop 7 of 75; 8 frames, 1 map with 80 landmarks\n")
        self.assertEqual(self.look(15.0, status(8)), "")
        self.log.write_text("[ INFO] [1]: the tour is done: 75 stops\n")
        self.assertIn("rovio1 at stop 75 of 75", self.look(20.0, status(8)))


class PictureTest(unittest.TestCase):
    def share(self, picture):
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            cv2.imwrite(file.name, picture)
            return demo_pictures.coloured_share(file.name)

    def setUp(self):
        self.picture = numpy.full((800, 1280, 3), (37, 34, 32), numpy.uint8)  # rviz, nothing in it

    def test_an_empty_view_has_no_colour(self):
        self.picture[::20] = 150  # the grid
        self.assertEqual(self.share(self.picture), 0.0)

    def test_colours_outside_the_view_do_not_count(self):
        self.picture[100:240, 60:280] = (20, 120, 220)  # the camera's image in its dock
        self.assertEqual(self.share(self.picture), 0.0)

    def test_a_map_is_enough(self):
        self.picture[400:480, 600:700] = (200, 120, 20)
        self.assertGreater(self.share(self.picture), demo_pictures.MIN_COLOURED_SHARE)

    def test_what_is_no_picture_is_named(self):
        with self.assertRaisesRegex(RuntimeError, "/no/such.png"):
            demo_pictures.coloured_share("/no/such.png")


if __name__ == "__main__":
    unittest.main()
