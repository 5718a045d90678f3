#!/usr/bin/python3
"""Scripts that draw and measure say in one sentence what is wrong with a file that a user names."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
# The arguments, the file at fault among them as FILE, others as OTHER.
CALLS = {
    "check_same": ["FILE", "."],
    "compare": ["FILE", "--out", "out"],
    "evaluate_cloud.py": ["OTHER", "FILE", "OTHER", "OTHER"],
    "expected_error.py": ["FILE"],
    "plot_cloud.py": ["FILE", "out.png"],
    "plot_laps.py": ["OTHER", "FILE", "3", "out.png"],
    "plot_long_drive.py": ["FILE", "out.png"],
    "plot_many_merges.py": ["FILE", "out.png"],
    "plot_map.py": ["FILE", "OTHER", "out.png"],
    "plot_merge.py": ["FILE", "OTHER", "OTHER", "OTHER", "OTHER", "out"],
    "plot_places.py": ["FILE", "out.png"],
    "plot_places_scale.py": ["FILE", "out.png"],
}
NO_ROWS = {"plot_many_merges.py", "plot_places.py", "plot_long_drive.py"}  # say so without the file
POSES = "".join(f"{i} {i} 0 0 0 0 0 1\n" for i in range(4))


def run(script, words, folder):
    return subprocess.run([sys.executable, SCRIPTS / script, *words], cwd=folder, capture_output=True, text=True,
                          timeout=120, check=False)


class ReadPlainlyTest(unittest.TestCase):
    def judge(self, script, named, folder):
        words = [named if word == "FILE" else "poses.txt" if word == "OTHER" else word for word in CALLS[script]]
        done = run(script, words, folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertRegex(done.stderr, rf"\A{script}: .*\n\Z")
        return done.stderr

    def test_a_file_that_is_not_there(self):
        for script in CALLS:
            with self.subTest(script), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "poses.txt").write_text(POSES)
                self.assertIn("nowhere", self.judge(script, "nowhere", folder))

    def test_a_file_of_another_kind(self):
        for script in CALLS:
            with self.subTest(script), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "poses.txt").write_text(POSES)
                (pathlib.Path(folder) / "wrong").write_text("no such thing\nat all\n")
                said = self.judge(script, "wrong", folder)
                if script not in NO_ROWS:
                    self.assertRegex(said, "wrong.*: .*expected|wrong/.*: Not a directory|no such folder")

    def test_a_folder_without_a_model_names_what_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "sparse/0").mkdir(parents=True)
            self.assertIn("sparse/0/cameras.txt: No such file", self.judge("expected_error.py", ".", folder))


if __name__ == "__main__":
    unittest.main()
