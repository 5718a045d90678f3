#!/usr/bin/python3
"""A driver whose robot answers oddly, that is not alone, sleeps, or has no clock: each is told, and
costs no more than what is wrong."""

import os
import signal
import subprocess
import sys
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Twist
from rovio_sfm.msg import RovioStatus
from sensor_msgs.msg import CompressedImage

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, Driver, diagnostic, program, wait_until
from odd_robot import OddRobot

WARN, ERROR = DiagnosticStatus.WARN, DiagnosticStatus.ERROR


class OddRobotTest(unittest.TestCase):
    def setUp(self):
        self.robot = OddRobot()
        self.driver = None
        self.images = Collector("/r3/image_raw/compressed", CompressedImage)
        self.diagnostics = Collector("/diagnostics", DiagnosticArray)

    def tearDown(self):
        if self.driver is not None and self.driver.is_alive():
            self.driver.stop()
        self.robot.stop()
        self.images.subscriber.unregister()
        self.diagnostics.subscriber.unregister()
        rospy.set_param("/use_sim_time", False)

    def start(self, **parameters):
        self.driver = Driver("r3", self.robot.port, {"images": {"source": "stills"}, **parameters})

    def wait_for_diagnosis(self, part, level, words, timeout_s=20):
        def is_so():
            now, message, _ = diagnostic(self.diagnostics, part)
            return now == level and words in message
        self.assertTrue(wait_until(is_so, timeout_s), diagnostic(self.diagnostics, part))

    def test_a_missing_field_is_named_and_images_come(self):
        self.robot.without("frame_rate")
        self.start()
        self.assertTrue(self.images.grows_by(5, 30), "no images")
        self.wait_for_diagnosis("robot", WARN, "frame_rate is missing")

    def test_an_odd_field_is_named_and_images_come(self):
        self.robot.fields = [f if not f.startswith("battery") else "battery=full" for f in self.robot.fields]
        self.start()
        self.assertTrue(self.images.grows_by(5, 30), "no images")
        self.wait_for_diagnosis("robot", WARN, "battery is no number")

    def test_a_nav_that_never_answers_is_told_and_images_come(self):
        self.robot.hangs.set()
        self.start(http={})
        self.wait_for_diagnosis("robot", ERROR, "no link", 10)
        self.assertTrue(self.images.grows_by(5, 40), "no images")

    def test_an_image_that_lost_data_is_dropped(self):
        self.start()
        self.assertTrue(self.images.grows_by(3, 30), "no images")
        whole = self.robot.jpeg
        self.robot.jpeg = whole[:len(whole) // 2] + b"\xff\xd9"
        self.assertTrue(wait_until(lambda: int(diagnostic(self.diagnostics, "images")[2].get(
            "dropped, corrupt", 0)) > 0, 20))
        self.robot.jpeg = whole
        self.assertTrue(self.images.grows_by(3, 20))
        self.assertEqual({bytes(image.data) for image in self.images.messages}, {whole})

    def test_diagnostics_come_once_a_second(self):
        self.start()
        self.assertTrue(self.images.grows_by(1, 30), "no images")
        self.assertTrue(self.diagnostics.grows_by(1, 5))
        begin = time.monotonic()
        self.assertTrue(self.diagnostics.grows_by(5, 20))
        self.assertLess(time.monotonic() - begin, 7.5)

    def begin(self, name):
        return subprocess.Popen([program("rovio_driver"), "__ns:=/r3", "__name:=" + name,
                                 "_host:=127.0.0.1", "_port:=%d" % self.robot.port],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def test_a_second_driver_says_so_and_does_not_drive(self):
        self.start()
        self.assertTrue(self.images.grows_by(1, 30), "no images")
        second = self.begin("second")
        said, _ = second.communicate(timeout=60)
        self.assertNotEqual(second.returncode, 0)
        self.assertIn("/r3/rovio_driver", said)
        self.assertTrue(self.images.grows_by(3, 20))

    def test_of_two_drivers_that_start_at_once_one_stays(self):
        both = [self.begin(name) for name in ("left", "right")]
        self.assertTrue(wait_until(lambda: any(driver.poll() is not None for driver in both), 60))
        loser = next(driver for driver in both if driver.poll() is not None)
        winner = next(driver for driver in both if driver is not loser)
        try:
            said, _ = loser.communicate(timeout=60)
            self.assertNotEqual(loser.returncode, 0)
            self.assertRegex(said, "published by /r3/(left|right)")
            self.assertTrue(self.images.grows_by(3, 30), "the other went too")
        finally:
            winner.send_signal(signal.SIGINT)
            winner.communicate(timeout=30)

    def test_a_command_that_waited_while_the_driver_slept_is_too_old(self):
        self.start()
        command = rospy.Publisher("/r3/cmd_vel", Twist, queue_size=1)
        twist = Twist()
        twist.linear.x = 0.15
        self.assertTrue(wait_until(lambda: command.get_num_connections() > 0, 30))
        def drives():
            command.publish(twist)
            return len(self.robot.drives) > 0
        self.assertTrue(wait_until(drives, 20, 0.1), "does not drive at all")
        self.driver.process.send_signal(signal.SIGSTOP)
        command.publish(twist)  # waits in the connection
        time.sleep(2.0)
        woken = time.monotonic()
        self.driver.process.send_signal(signal.SIGCONT)
        self.assertTrue(self.images.grows_by(3, 20), "does not go on")
        self.assertEqual([drive for drive in self.robot.drives if drive[0] > woken + 0.02], [])
        count = len(self.robot.drives)
        self.assertTrue(wait_until(lambda: drives() and len(self.robot.drives) > count, 20, 0.1))
        command.unregister()

    def test_without_a_clock_it_lives_and_drops_images(self):
        rospy.set_param("/use_sim_time", True)
        status = Collector("/r3/status", RovioStatus)
        self.start(image_latency_s=0.1)
        self.assertTrue(status.grows_by(3, 30))
        self.assertTrue(wait_until(lambda: status.last().images_dropped > 0, 20), status.last())
        self.assertTrue(self.driver.is_alive())


if __name__ == "__main__":
    rospy.init_node("driver_odd_robot_node_test")
    rostest.rosrun("rovio_sfm", "driver_odd_robot", OddRobotTest)
