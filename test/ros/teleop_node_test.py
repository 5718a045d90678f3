#!/usr/bin/python3
"""teleop on a virtual display, with keys pressed and let go as a hand does."""

import os
import signal
import subprocess
import sys
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import Twist

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until

WAIT_S = 30.0


class TeleopNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        read_end, write_end = os.pipe()
        cls.display = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-nolisten", "tcp"],
                                       pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as numbers:
            cls.environment = dict(os.environ, DISPLAY=":" + numbers.readline().strip())
        cls.commands = Collector("/rovio1/cmd_vel", Twist)
        script = roslib.packages.find_node("rovio_sfm", "teleop")[0]
        cls.teleop = subprocess.Popen([script, "__ns:=rovio1", "_linear_m_s:=0.2"], env=cls.environment)
        assert wait_until(lambda: cls.commands.subscriber.get_num_connections() == 1, WAIT_S)
        assert wait_until(cls.has_window, WAIT_S)

    @classmethod
    def tearDownClass(cls):
        for process in (cls.teleop, cls.display):
            process.send_signal(signal.SIGTERM)
            process.wait(WAIT_S)

    @classmethod
    def xdotool(cls, *words):
        return subprocess.run(["xdotool", *words], env=cls.environment, capture_output=True, text=True,
                              check=False)

    @classmethod
    def has_window(cls):
        return cls.xdotool("search", "--onlyvisible", "--name", "teleop rovio1").stdout != ""

    def newest(self):
        twist = self.commands.last() if self.commands.count() else Twist()
        return twist.linear.x, twist.linear.y, twist.angular.z

    def test_key_moves_the_robot_until_it_is_let_go(self):
        for key, motion in (("Up", (0.2, 0, 0)), ("s", (-0.2, 0, 0)), ("Left", (0, 0, 0.8)),
                            ("period", (0, -0.2, 0))):
            self.xdotool("keydown", key)
            self.assertTrue(wait_until(lambda m=motion: self.newest() == m, WAIT_S), (key, self.newest()))
            self.assertTrue(self.commands.grows_by(8, WAIT_S))  # again and again: a command expires
            self.assertEqual(self.newest(), motion)
            self.xdotool("keyup", key)
            self.assertTrue(wait_until(lambda: self.newest() == (0, 0, 0), WAIT_S), key)

    def test_two_keys_are_one_motion(self):
        for key in ("w", "a"):
            self.xdotool("keydown", key)
        self.assertTrue(wait_until(lambda: self.newest() == (0.2, 0, 0.8), WAIT_S), self.newest())
        for key in ("w", "a"):
            self.xdotool("keyup", key)
        self.assertTrue(wait_until(lambda: self.newest() == (0, 0, 0), WAIT_S))


if __name__ == "__main__":
    rospy.init_node("teleop_node_test")
    rostest.rosrun("rovio_sfm", "teleop_node_test", TeleopNodeTest, sys.argv)
