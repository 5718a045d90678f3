#!/usr/bin/python3
"""Scripts as users call them: with CDPATH, through symlinks, from elsewhere, asked for help; record_inputs refuses what
would be lost, and passes on what it does not know."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RECORD = ROOT / "scripts/record_inputs"
# Words that a script does not know; the last is at fault.
REFUSED = {
    "build": ["--only", "util_test", "word"],
    "check_docs": ["word"],
    "check_format": ["word"],
    "check_layers": ["word"],
    "count_option_lines": ["HEAD", "word"],
    "demo": ["--no-install", "--out"],
    "fuzz": ["1", "word"],
    "install_dependencies": ["--peers", "word"],
    "screenshot": ["--no-install", "word"],
    "test": ["word"],
    "test_long": ["fuzz", "word"],
    "test_sanitized": ["word"],
    "write_options": ["word"],
}


class Scripts(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="a user's ")
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def run_in_folder(self, *command, **variables):
        return subprocess.run([str(word) for word in command], cwd=self.folder, capture_output=True,
                              text=True, check=False, env=dict(os.environ, **variables))

    def test_environment_finds_the_sources_from_anywhere(self):
        (self.folder / "tree").symlink_to(ROOT)
        for name in (ROOT, self.folder / "tree"):
            done = self.run_in_folder("bash", "-c", '. "$0"; echo "<$root>"', name / "scripts/environment",
                                      CDPATH=f".:/:{self.folder}")
            self.assertEqual(done.stdout, f"<{ROOT}>\n", done.stderr)

    def test_every_script_finds_its_environment_through_a_symlink(self):
        for script in sorted((ROOT / "scripts").iterdir()):
            text = script.read_text() if script.is_file() else ""
            if "/environment" in text and text.startswith("#!") and "bash" in text.splitlines()[0]:
                self.assertIn('. "$(dirname "$(readlink -f "$0")")/environment"', text, script.name)

    def test_every_script_tells_what_it_does_and_refuses_what_it_does_not_know(self):
        for script in sorted((ROOT / "scripts").iterdir()):
            if not script.is_file() or not os.access(script, os.X_OK):
                continue
            (self.folder / "linked").unlink(missing_ok=True)
            (self.folder / "linked").symlink_to(script)
            with self.subTest(script.name):
                done = self.run_in_folder(self.folder / "linked", "--help", CDPATH=f".:/:{self.folder}")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertGreaterEqual(len(done.stdout.strip()), 60)
                done = self.run_in_folder(script, "--nonsense")
                self.assertIn(done.returncode, (1, 2))
                self.assertNotIn("Traceback", done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertRegex(done.stderr, "--nonsense|expected|required")

    def test_scripts_without_options_refuse_words(self):
        for name, words in REFUSED.items():
            with self.subTest(name):
                done = self.run_in_folder(ROOT / "scripts" / name, *words)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertRegex(done.stderr, rf"\A{name}: '?{words[-1]}.*expected .*\n\Z")

    def record(self, bag):
        """With a rosrun that shows what it would run."""
        (self.folder / "bin").mkdir(exist_ok=True)
        rosrun = self.folder / "bin/rosrun"
        rosrun.write_text('#!/bin/sh\nfor word in "$@"; do echo "$word"; done\n')
        rosrun.chmod(0o755)
        return self.run_in_folder(RECORD, bag, "rovio1,rovio2", "/tf:=/tf_inputs", "__name:=record",
                                  PATH=f"{self.folder / 'bin'}:{os.environ['PATH']}")

    def test_record_takes_the_inputs_of_all_robots(self):
        done = self.record(self.folder / "a bag")
        self.assertEqual(done.returncode, 0, done.stderr)
        words = done.stdout.splitlines()
        self.assertEqual(words[:4], ["rosbag", "record", "--output-name", f"{self.folder}/a bag.bag"])
        for topic in ("/tf", "/rovio1/odom", "/rovio2/image_raw/compressed", "/rovio2/camera_info"):
            self.assertIn(topic, words)
        self.assertEqual(words[-2:], ["/tf:=/tf_inputs", "__name:=record"])

    def test_record_replaces_nothing(self):
        for there in ("a.bag", "b.bag.active"):
            (self.folder / there).write_text("precious")
        for bag, reason in (("a.bag", "is there already"), ("a", "is there already"),
                            ("b.bag", "rosbag reindex"), ("absent/c.bag", "no such folder")):
            done = self.record(self.folder / bag)
            self.assertEqual(done.returncode, 1, bag)
            self.assertIn(reason, done.stderr)
            self.assertEqual(done.stdout, "")
        self.assertIn("absolute", self.record("c.bag").stderr)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main()
