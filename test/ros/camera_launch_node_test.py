#!/usr/bin/python3
"""camera.launch with a camera that is no Rovio: its topics are guessed; and a frontend that is told its
topic, and its calibration by a file."""

import os
import subprocess
import sys
import unittest

import cv2
import numpy
import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg
from sensor_msgs.msg import CameraInfo, Image

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, program, wait_until

WAIT_S = 60.0  # sanitizers and busy machines take their time


class CameraLaunchNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        small = numpy.random.RandomState(1).randint(0, 255, (60, 80, 3), dtype=numpy.uint8)
        cls.picture = cv2.resize(small, (640, 480), interpolation=cv2.INTER_CUBIC)
        cls.image = rospy.Publisher("/usb_cam/image_raw", Image, queue_size=5)
        cls.info = rospy.Publisher("/usb_cam/camera_info", CameraInfo, queue_size=5)
        assert wait_until(lambda: cls.image.get_num_connections() == 1
                          and cls.info.get_num_connections() == 1, WAIT_S), "not subscribed"
        cls.other = rospy.Publisher("/other_cam/image", Image, queue_size=5)
        assert wait_until(lambda: cls.other.get_num_connections() == 1, WAIT_S), "not subscribed"

    def send(self, publisher, with_info):
        image = Image(height=480, width=640, encoding="bgr8", step=3 * 640)
        image.header.stamp, image.header.frame_id = rospy.Time.now(), "head_camera"
        image.data = self.picture.tobytes()
        if with_info:
            info = CameraInfo(header=image.header, width=640, height=480, D=[0.0] * 5,
                              distortion_model="plumb_bob")
            info.K = [500.0, 0, 320.0, 0, 500.0, 240.0, 0, 0, 1.0]
            self.info.publish(info)
        publisher.publish(image)

    def first_frame(self, robot, publisher, with_info):
        frames = Collector("/%s/frames" % robot, FrameEventMsg)
        for _ in range(int(WAIT_S / 2)):
            self.send(publisher, with_info)
            if wait_until(lambda: frames.count() > 0, 2.0):
                return frames.last()
        raise AssertionError("no frame event came")

    def test_only_topics_of_their_kind_are_found(self):
        frame = self.first_frame("guessing", self.image, True)
        self.assertEqual(frame.id.drive.robot, "guessing")
        self.assertEqual((frame.camera.width, frame.camera.fx_px), (640, 500.0))
        self.assertFalse(frame.has_odometry)

    def test_calibration_of_a_file_does_instead_of_camera_info(self):
        frame = self.first_frame("told", self.other, False)
        self.assertEqual((frame.camera.width, frame.camera.fx_px), (640, 500.0))

    def test_several_topics_of_a_kind_are_listed(self):
        done = subprocess.run([program("frontend"), "__ns:=/lost", "_topics/image:=guess"],
                              capture_output=True, text=True, timeout=WAIT_S, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("/other_cam/image /usb_cam/image_raw; choose one with image:=TOPIC",
                      done.stdout + done.stderr)


if __name__ == "__main__":
    rospy.init_node("camera_launch_node_test")
    rostest.rosrun("rovio_sfm", "camera_launch_node_test", CameraLaunchNodeTest, sys.argv)
