#!/usr/bin/python3
"""A running frontend: thresholds by dynamic_reconfigure hold from the next image on; diagnostics."""

import os
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
from rovio_sfm.msg import FrameEventMsg
from sensor_msgs.msg import CameraInfo

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, diagnostic, wait_until
from robot_images import Robot, WAIT_S


class FrontendThresholdsNodeTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.frames = Collector("/rovio1/frames", FrameEventMsg)
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)
        cls.robot = Robot("rovio1")
        assert cls.robot.wait_until_heard()
        cls.client = Client("/rovio1/frontend/thresholds", timeout=WAIT_S)

    def next_frame(self, shift_px):
        return self.robot.send_until_frame(self.frames, shift_px)

    def test_messages_of_no_use_are_told_while_they_come(self):
        self.robot.info.publish(CameraInfo(width=640, height=480, distortion_model="plumb_bob"))

        def told():
            return diagnostic(self.diagnostics, "images to frames")

        self.assertTrue(wait_until(lambda: "camera_info refused" in told()[1], WAIT_S), told())
        self.assertEqual((told()[0], told()[2]["malformed messages"]), (1, "1"))
        self.next_frame(0)
        self.assertTrue(self.diagnostics.grows_by(2, WAIT_S))
        self.assertIn("camera_info refused", told()[1])

    def test_starts_with_the_options_of_the_node(self):
        values = self.client.get_configuration(timeout=WAIT_S)
        self.assertEqual(values["recursion_max_frames"], 5)
        self.assertEqual(values["recursion_min_matches"], 30)

    def test_change_holds_from_the_next_image_on_in_the_same_drive(self):
        before = [self.next_frame(shift_px) for shift_px in (0, 4, 8)]
        self.assertGreaterEqual(len(before[2].pairs), 2)
        self.client.update_configuration({"recursion_max_frames": 1})
        after = self.next_frame(12)
        self.assertEqual(len(after.pairs), 1)
        self.assertEqual(after.id.drive, before[2].id.drive)
        self.client.update_configuration({"recursion_max_frames": 5})

    def test_refused_values_leave_the_old_ones(self):
        values = self.client.update_configuration({"choose_spoilt_share": 0.9, "min_features": 25})
        self.assertAlmostEqual(values["choose_spoilt_share"], 0.2)
        self.assertEqual(values["min_features"], 20)


if __name__ == "__main__":
    rospy.init_node("frontend_thresholds_node_test")
    rostest.rosrun("rovio_sfm", "frontend_thresholds_node_test", FrontendThresholdsNodeTest, sys.argv)
