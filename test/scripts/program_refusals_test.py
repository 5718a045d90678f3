#!/usr/bin/python3
"""Every program says on the terminal why it ends: a bad option, a bad file, no master.

program_refusals_test.py FOLDER, where FOLDER holds the programs."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import xmlrpc.client

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
sys.dont_write_bytecode = True

from demo_graph import free_ports  # noqa: E402  (after the path is set)

PROGRAMS = sys.argv.pop(1) if len(sys.argv) > 1 else ""
NOWHERE = "/nowhere/at_all"
LONG_S = 120

# Arguments of a node with a file that is not there; the word that its message holds.
NODES = {
    "drive_tour": ([f"_tour:={NOWHERE}"], NOWHERE),
    "frontend": (["_image_latency_s:=now"], "image_latency_s"),
    "map_web": (["_address:=192.0.2.1"], "cannot listen on 192.0.2.1:8090"),
    "mapping": (["_output_dir:=/proc/nowhere"], "/proc/nowhere"),
    "place_recognition": ([f"_vocabulary:={NOWHERE}"], NOWHERE),
    "rovio_driver": (["_host:=127.0.0.1", f"_credentials_file:={NOWHERE}"], NOWHERE),
}
# What a node waits for says so, and that no time passes.
AWAITED = {
    "frontend": ["no images on /rovio1/image_raw/compressed yet; topics of that type: none",
                 "no camera_info on /rovio1/camera_info yet", "nobody publishes /clock"],
    "mapping": ["no frames on /rovio1/frames yet; topics of that type: none", "nobody publishes /clock"],
    "place_recognition": ["no frames on /rovio1/frames yet; topics of that type: none",
                          "nobody publishes /clock"],
}
TOOLS = {
    "calibrate_camera": [NOWHERE, "--out", "{out}/camera.yaml"],
    "evaluate_places": ["--query", NOWHERE, "--database", NOWHERE, "--out", "{out}"],
    "evaluate_trajectory": [NOWHERE, NOWHERE],
    "images_to_bag": [NOWHERE, "{out}/drive.bag"],
    "map_images": [NOWHERE, "--out", "{out}"],
    "map_tool": ["info", NOWHERE],
    "measure_noise": [NOWHERE],
    "replay": [NOWHERE, "--out", "{out}", "--places", "none"],
    "rovio_sim": ["--images", NOWHERE, "--port", "0"],
    "train_places": [NOWHERE, "--out", "{out}/model.places"],
}
NOT_FINITE = {
    "evaluate_places": ("--min-score", "--ratio"),
    "evaluate_trajectory": ("--max-gap",),
    "replay": ("--image-latency", "--odom-latency"),
    "rovio_sim": ("--noise", "--rolling-shutter", "--steps"),
    "train_places": ("--p-z-given-e",),
}
# Numbers that no program takes: the words, and what the message says.
NUMBERS = {
    "evaluate_places": (["--seed", "-1"], "--seed: expected a whole number, 0 to "),
    "images_to_bag": (["--max-images", "-3"], "--max-images: expected a whole number, 0 to "),
    "map_images": (["--seed", "-1"], "--seed: expected a whole number, 0 to "),
    "map_tool": (["export", "--map", "-1"], "--map: Value -1 not in range 1 to 4294967295"),
    "replay": (["--seed", "1.5"], "--seed: expected a whole number, not '1.5'"),
    "rovio_sim": (["--seed", "-1"], "--seed: expected a whole number, 0 to "),
    "train_places": (["--images", "-3"], "--images: expected a whole number, 0 to "),
}


def environment(port):
    """Messages are read from a pipe, without colours."""
    inherited = {name: value for name, value in os.environ.items() if name != "ROSCONSOLE_STDOUT_LINE_BUFFERED"}
    return dict(inherited, ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_HOME=tempfile.gettempdir(),
                ROS_NAMESPACE="rovio1")


class Master:
    """A ROS master alone, without roslaunch."""

    def __enter__(self):
        self.port = free_ports(1)
        self.process = subprocess.Popen(
            ["rosmaster", "--core", "-p", str(self.port)], env=environment(self.port),
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        server = xmlrpc.client.ServerProxy(f"http://127.0.0.1:{self.port}")
        end = time.monotonic() + LONG_S
        while time.monotonic() < end:
            try:
                server.getPid("/test")
                return self
            except ConnectionRefusedError:
                time.sleep(0.05)
        raise RuntimeError("the master does not answer")

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(LONG_S)


def run(program, arguments, port):
    """Exit status, standard output and standard error."""
    done = subprocess.run([os.path.join(PROGRAMS, program), *arguments], env=environment(port),
                          capture_output=True, text=True, timeout=LONG_S, check=False)
    return done.returncode, done.stdout, done.stderr


class ProgramRefusalsTest(unittest.TestCase):
    def test_tools_name_a_bad_option_and_a_bad_file(self):
        for program, arguments in TOOLS.items():
            with self.subTest(program), tempfile.TemporaryDirectory() as folder:
                out = os.path.join(folder, "new")
                words = [word.format(out=out) for word in arguments]
                for wrong, named in ((["--robotz"], ""), ([*words, "--robotz"], "--robotz"), (words, NOWHERE)):
                    status, told, said = run(program, wrong, 1)
                    self.assertEqual((status, told), (1, ""))
                    self.assertTrue(said.startswith(f"{program}: "), said)
                    self.assertIn(named, said)
                    self.assertEqual(os.listdir(folder), [])  # what is refused leaves nothing behind

    def test_tools_help_on_standard_output(self):
        for program in TOOLS:
            with self.subTest(program):
                status, told, said = run(program, ["--help"], 1)
                self.assertEqual((status, said), (0, ""))
                self.assertIn("--help", told)

    def test_tools_refuse_numbers_that_would_wrap_round(self):
        for program, (words, complaint) in NUMBERS.items():
            with self.subTest(program):
                status, told, said = run(program, words, 1)
                self.assertEqual((status, told), (1, ""))
                self.assertIn(complaint, said)

    def test_tools_refuse_numbers_that_are_not_finite(self):
        for program, options in NOT_FINITE.items():
            for option in options:
                with self.subTest(program, option=option):
                    status, told, said = run(program, [option, "nan"], 1)
                    self.assertEqual((status, told), (1, ""))
                    self.assertIn(f"{option}: expected a finite number, not 'nan'", said)

    def test_no_option_that_takes_a_number_is_forgotten(self):
        for program in TOOLS:
            with self.subTest(program):
                _, told, _ = run(program, ["--help"], 1)
                options = {line.split()[0] for line in told.splitlines() if " FLOAT" in line}
                self.assertEqual(options, set(NOT_FINITE.get(program, ())))

    def test_nodes_name_a_bad_option_and_a_bad_value(self):
        with Master() as master:
            for program, (arguments, word) in NODES.items():
                with self.subTest(program):
                    status, _, said = run(program, ["_robotz:=1"], master.port)
                    self.assertEqual(status, 1)
                    self.assertIn("robotz", said)
                    status, _, said = run(program, [f"__name:={program}2", *arguments], master.port)
                    self.assertEqual(status, 1)
                    self.assertIn(word, said)

    def test_nodes_say_what_they_wait_for(self):
        with Master() as master:
            server = xmlrpc.client.ServerProxy(f"http://127.0.0.1:{master.port}")
            self.assertEqual(server.setParam("/test", "/use_sim_time", True)[0], 1)
            for program, words in AWAITED.items():
                with self.subTest(program):
                    node = subprocess.Popen([os.path.join(PROGRAMS, program)], text=True,
                                            env=environment(master.port), stdout=subprocess.PIPE,
                                            stderr=subprocess.STDOUT)
                    missing = set(words)
                    limit = threading.Timer(LONG_S, node.kill)
                    limit.start()
                    for line in node.stdout:
                        missing = {word for word in missing if word not in line}
                        if not missing:
                            break
                    limit.cancel()
                    node.send_signal(signal.SIGTERM)
                    node.communicate(timeout=LONG_S)
                    self.assertEqual(missing, set())
                    self.assertEqual(node.returncode, 0)

    def test_nodes_name_a_bad_name(self):
        for program in NODES:
            with self.subTest(program):
                status, _, said = run(program, ["__name:=a/b"], 1)
                self.assertEqual(status, 1)
                self.assertIn("a/b", said)

    def test_nodes_end_while_they_wait_for_a_master(self):
        for program in NODES:
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(program, signal=number):
                    node = subprocess.Popen([os.path.join(PROGRAMS, program)],
                                            env=environment(free_ports(1)), text=True,
                                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                    line = node.stdout.readline()
                    self.assertIn("waiting for the ROS master at http://127.0.0.1", line)
                    node.send_signal(number)
                    rest, _ = node.communicate(timeout=LONG_S)
                    self.assertIn("ended while waiting", rest)
                    self.assertEqual(node.returncode, 128 + number)


if __name__ == "__main__":
    if not PROGRAMS:
        sys.exit(__doc__)
    unittest.main()
