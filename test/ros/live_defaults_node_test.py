#!/usr/bin/python3
"""rovio.launch with nothing but the robot's address, as its user starts it: the robot's stream in, keyframes
by parallax, a map while it drives."""

import os
import signal
import subprocess
import sys
import unittest

import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg, MapStatus

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, Simulator, program, wait_until

WAIT_S = 120.0  # sanitizers and busy machines take their time
MIN_KEYFRAMES = 8


class LiveDefaultsNodeTest(unittest.TestCase):
    def test_stream_becomes_a_map_with_keyframes_and_light_frames(self):
        simulator = Simulator("--serve", "--tour", "visionlab", "--seed", "1")
        self.addCleanup(simulator.stop)
        frames, status = Collector("/rovio1/frames", FrameEventMsg), Collector("/map_status", MapStatus)
        self.launch("roslaunch", "rovio_sfm", "rovio.launch", "host:=127.0.0.1",
                    "port:=%d" % simulator.port)
        self.assertTrue(wait_until(lambda: frames.count() > 0, WAIT_S), "no frame")
        tour = os.path.join(os.path.dirname(program("drive_tour")),
                            "../../share/rovio_sfm/config/tours/visionlab.yaml")
        self.launch(program("drive_tour"), "__ns:=rovio1", "_look:=nothing", "_tour:=" + tour)
        self.assertTrue(wait_until(lambda: self.is_mapped(status), WAIT_S), status.messages[-1:])

    @staticmethod
    def is_mapped(status):
        """One session has keyframes and light frames, and its map landmarks and a scale."""
        if status.count() == 0:
            return False
        newest = status.last()
        sessions = [s for s in newest.sessions
                    if s.num_keyframes >= MIN_KEYFRAMES and s.num_light_frames > 0]
        maps = [m for m in newest.maps if m.num_landmarks > 100 and m.metric]
        return bool(sessions) and bool(maps)

    def launch(self, *command):
        process = subprocess.Popen(command, start_new_session=True)
        self.addCleanup(process.wait, 60)
        self.addCleanup(process.send_signal, signal.SIGINT)


if __name__ == "__main__":
    rospy.init_node("live_defaults_node_test")
    rostest.rosrun("rovio_sfm", "live_defaults_node_test", LiveDefaultsNodeTest, sys.argv)
